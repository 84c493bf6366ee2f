#pragma once

#include "course/Hemicube.h"
#include "viewer/Running.h"

namespace radlab {

/// A hemicube that says that renderPatchIDs is running while it draws, whoever asked it to.
class WatchedHemicube : public Hemicube {
public:
    WatchedHemicube(int size, RunningNow& now) : Hemicube(size), running(now) {}

    void renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                     const std::function<void()>& draw) override {
        Hemicube::renderScene(eye, up, direction, [&] {
            const RunningMark mark(running, Running::renderPatchIDs);
            draw();
        });
    }

private:
    RunningNow& running;
};

}  // namespace radlab
