#include "grader/stages/ManyPatches.h"

#include <algorithm>

namespace radlab::grader {

namespace {

void addCell(State& state, int cells, const std::vector<int>& corners) {
    MyPolygon patch;
    patch.vertices = static_cast<int>(corners.size());
    std::copy(corners.begin(), corners.end(), patch.vertex);
    for (const int c : corners)
        patch.center += state.corners[static_cast<std::size_t>(c)].position / static_cast<float>(corners.size());
    patch.normal = Vec3f(0.0f, 0.0f, 1.0f);
    patch.area = static_cast<float>((corners.size() == 4 ? 4.0 : 2.0) / (cells * cells));
    state.patches.push_back(patch);
}

}  // namespace

State wall(Random& random, int cells) {
    State state;
    const auto place = [cells](int i) { return static_cast<float>(2.0 * i / cells - 1.0); };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            state.corners.emplace_back();
            state.corners.back().position = Vec3f(place(column), place(row), 0.0f);
        }
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const int a = row * (cells + 1) + column, b = a + 1, d = a + cells + 1, c = d + 1;
            if (random.index(5) > 0) {
                addCell(state, cells, {a, b, c, d});
            } else {
                addCell(state, cells, {a, b, c});
                addCell(state, cells, {a, c, d});
            }
        }
    return state;
}

void append(State& state, const State& more) {
    const int shift = static_cast<int>(state.corners.size());
    state.corners.insert(state.corners.end(), more.corners.begin(), more.corners.end());
    for (MyPolygon patch : more.patches) {
        for (int i = 0; i < patch.vertices; ++i) patch.vertex[i] += shift;
        state.patches.push_back(patch);
    }
}

}  // namespace radlab::grader
