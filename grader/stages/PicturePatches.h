#pragma once

#include <string>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// The patches of a state, as the course's globals would have them.
struct PicturePatches {
    explicit PicturePatches(State of) : state(std::move(of)) {
        for (MyPolygon& patch : state.patches) polygons.push_back(&patch);
        for (MyVertex& corner : state.corners) corners.push_back(&corner);
    }
    PicturePatches(const PicturePatches&) = delete;
    PicturePatches& operator=(const PicturePatches&) = delete;

    State state;
    std::vector<MyPolygon*> polygons;
    std::vector<MyVertex*> corners;
};

/// The channels of a picture in floats, for stages whose outcome is one.
inline Numbers pictureNumbers(const Outcome& outcome) {
    return {outcome.pixels, outcome.slack.empty() ? std::vector<double>(outcome.pixels.size()) : outcome.slack};
}

/// "picture.at(3, 7).g" of channel k.
inline std::string pixelName(const Step& step, std::size_t k) {
    const auto width = static_cast<std::size_t>(step.width);
    return "picture.at(" + std::to_string(k / 3 % width) + ", " + std::to_string(k / 3 / width) + ")." + "rgb"[k % 3];
}

}  // namespace radlab::grader
