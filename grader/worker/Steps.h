#pragma once

#include <memory>
#include <utility>

#include "course/PatchMesh.h"
#include "gl/Context.h"
#include "grader/protocol/Message.h"
#include "grader/worker/Submission.h"
#include "grader/worker/WatchedHemicube.h"

namespace radlab::grader {

/// Performs the steps of a request, one after the other, on one mesh of patches.
///
/// A hemicube, and without a context an OpenGL context, too, are made when the first step needs them, and kept.
class Steps {
public:
    Steps(Submission& loaded, std::unique_ptr<GlContext> started) : submission(loaded), context(std::move(started)) {}

    /// Prepares the state, calls the function, and says what is left.
    ///
    /// What the function throws ends up in the answer. The step's state is moved out of it, and the one that is left into the answer.
    StepAnswer perform(Step& step);

    /// Moves the state back, for the next step.
    void takeBack(StepAnswer& answer);

private:
    void prepare(Step& step);
    void call(const Step& step, StepAnswer& answer);
    void draw(const Step& step, StepAnswer& answer);
    std::vector<Vec3f> sampled(const Step& step);
    std::vector<Vec3f> mirrored(const Step& step);
    const MyPolygon* shootRays(const Step& step);
    void solve(const Step& step, StepAnswer& answer);
    void startOpenGl();
    void prepareHemicube(const Step& step);
    int indexOf(const MyPolygon* patch) const;
    MyPolygon* patchAt(int index);

    Submission& submission;
    PatchMesh mesh;
    std::unique_ptr<GlContext> context;
    std::unique_ptr<WatchedHemicube> hemicube;
};

}  // namespace radlab::grader
