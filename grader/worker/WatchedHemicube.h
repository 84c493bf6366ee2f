#pragma once

#include <vector>

#include "course/Hemicube.h"
#include "grader/protocol/Message.h"

namespace radlab::grader {

/// A hemicube that notes how it is used, and that can draw the patch IDs itself.
class WatchedHemicube : public Hemicube {
public:
    using Hemicube::Hemicube;

    void renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                     const std::function<void()>& draw) override;
    void readIndexBuffer() override;

    std::vector<HemicubeCall> calls;
    bool drawsItself = false;  ///< renderScene draws `polygons` itself instead of calling the function that it is given
};

}  // namespace radlab::grader
