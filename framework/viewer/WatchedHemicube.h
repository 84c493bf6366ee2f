#pragma once

#include "course/Hemicube.h"
#include "viewer/Running.h"

namespace radlab {

/// A hemicube that says that renderPatchIDs is running while it draws, whoever asked it to, and lets something else be done between
/// its faces and round its reading back.
class WatchedHemicube : public Hemicube {
public:
    /// @param between may draw elsewhere if it puts all OpenGL state back
    WatchedHemicube(int size, RunningNow& now, std::function<void()> between)
        : Hemicube(size), running(now), interlude(std::move(between)) {}

    void renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                     const std::function<void()>& draw) override {
        Hemicube::renderScene(eye, up, direction, [&] {
            interlude();
            const RunningMark mark(running, Running::renderPatchIDs);
            draw();
        });
    }

    void readIndexBuffer() override {
        interlude();
        Hemicube::readIndexBuffer();
        interlude();
    }

private:
    RunningNow& running;
    std::function<void()> interlude;
};

}  // namespace radlab
