#include "grader/stages/ColorCases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grader/stages/Meshes.h"

namespace radlab::grader {

namespace {

Step callFor(const std::vector<std::string>& wanted) {
    Step step;
    step.function = "colorReconstruction";
    step.wanted = wanted;
    return step;
}

Case caseOf(const std::string& what, State state, const std::vector<std::string>& wanted, int calls = 1) {
    Case asked{what, std::vector<Step>(static_cast<std::size_t>(calls), callFor(wanted))};
    asked.steps.front().state = std::move(state);
    return asked;
}

// As before the very first call.
State fresh(State state) {
    for (MyPolygon& patch : state.patches) patch.color = Vec3f(0.0f);
    for (MyVertex& corner : state.corners) {
        corner.color = corner.rad = Vec3f(0.0f);
        corner.colorcount = 0;
    }
    return state;
}

State boxes(Random& random, float patchSize, int blocks) {
    State state = room(random, patchSize, blocks);
    shuffle(random, state);
    return state;
}

// Triangles around one vertex, which all of them share; every other vertex belongs to one or two.
State fan(Random& random, int triangles, bool closed) {
    State state;
    const int ring = closed ? triangles : triangles + 1;
    const float turn = (closed ? 2.0f : 1.5f) * std::numbers::pi_v<float> / static_cast<float>(triangles);
    state.corners.resize(static_cast<std::size_t>(ring) + 1);
    for (int i = 0; i < ring; ++i) {
        const float angle = turn * static_cast<float>(i);
        state.corners[static_cast<std::size_t>(i) + 1].position = Vec3f(std::cos(angle), std::sin(angle), 0.0f);
    }
    for (int i = 0; i < triangles; ++i) {
        MyPolygon patch;
        patch.vertices = 3;
        patch.vertex[0] = 0;
        patch.vertex[1] = 1 + i;
        patch.vertex[2] = 1 + (i + 1) % ring;
        patch.area = static_cast<float>(random.between(0.2, 2.0));
        patch.normal = Vec3f(0.0f, 0.0f, 1.0f);
        state.patches.push_back(patch);
    }
    randomLight(random, state);
    shuffle(random, state);
    return state;
}

// A strip of quads side by side, two triangles at its end.
State strip(Random& random, int quads) {
    State state;
    for (int i = 0; i <= quads + 1; ++i)
        for (const float y : {0.0f, 1.0f}) {
            state.corners.emplace_back();
            state.corners.back().position = Vec3f(static_cast<float>(i), y, 0.0f);
        }
    const auto add = [&](const std::vector<int>& corners) {
        MyPolygon patch;
        patch.vertices = static_cast<int>(corners.size());
        std::copy(corners.begin(), corners.end(), patch.vertex);
        patch.area = static_cast<float>(random.between(0.2, 2.0));
        patch.normal = Vec3f(0.0f, 0.0f, 1.0f);
        state.patches.push_back(patch);
    };
    for (int i = 0; i < quads; ++i) add({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    const int last = 2 * quads;
    add({last, last + 2, last + 3});
    add({last, last + 3, last + 1});
    randomLight(random, state);
    return state;
}

// The fourth index of a triangle leads to a corner of another patch; nobody has to read it.
State withFourthIndices(Random& random, State state) {
    for (MyPolygon& patch : state.patches) {
        if (patch.vertices != 3) continue;
        do {
            patch.vertex[3] = random.index(state.corners.size());
        } while (std::count(patch.vertex, patch.vertex + 3, patch.vertex[3]) > 0);
    }
    return state;
}

// Vertices that no patch uses, among those that some do.
State withOrphans(Random& random, State state) {
    for (int i = 0; i < 4; ++i) {
        const int place = random.index(state.corners.size() + 1);
        MyVertex orphan;
        orphan.color = random.vector(1.0, 5.0);
        orphan.rad = random.vector(1.0, 5.0);
        orphan.colorcount = 2 + random.index(3);
        state.corners.insert(state.corners.begin() + place, orphan);
        for (MyPolygon& patch : state.patches)
            for (int& corner : patch.vertex) corner += corner >= place;
    }
    return state;
}

State overTwelveOrders(Random& random, State state) {
    for (MyPolygon& patch : state.patches) patch.rad *= static_cast<float>(random.magnitude(1e-6, 1e6));
    return state;
}

const std::vector<std::string> flat = {"patch.color"}, smooth = {"corner.color"};

std::vector<Check> flatChecks(Random& random) {
    const auto indexed = [&](State state) { return withFourthIndices(random, std::move(state)); };
    return {
        {"color.flat",
         {caseOf("one strip of patches", indexed(fresh(strip(random, 1))), flat),
          caseOf("a room", indexed(fresh(boxes(random, 0.7f, 1))), flat)}},
        {"color.range",
         {caseOf("radiosities over twelve orders of magnitude",
                 indexed(overTwelveOrders(random, fresh(boxes(random, 0.7f, 1)))), flat)}},
        {"color.repeat",
         // First in its process: what is not there must not be found in memory that an earlier case has left.
         {caseOf("no patches", State{}, flat),
          caseOf("two calls, one after the other", indexed(strip(random, 2)), flat, 2)}},
    };
}

Check meansCheck(Random& random) {
    return {"color.nodal",
            {caseOf("a strip of patches", fresh(strip(random, 2)), smooth),
             caseOf("three triangles that share a vertex", fresh(fan(random, 3, false)), smooth),
             caseOf("four triangles that share a vertex", fresh(fan(random, 4, true)), smooth),
             caseOf("seven triangles that share a vertex", fresh(fan(random, 7, true)), smooth),
             caseOf("a room with boxes and triangles in it", fresh(boxes(random, 0.5f, 2)), smooth),
             caseOf("a room, radiosities over twelve orders of magnitude",
                    overTwelveOrders(random, fresh(boxes(random, 0.7f, 1))), smooth)}};
}

std::vector<Check> smoothChecks(Random& random) {
    const std::vector<std::string> radiosity = {"corner.rad"}, count = {"corner.colorcount"};
    return {
        meansCheck(random),
        {"color.again",
         {caseOf("old colours at patches and vertices", strip(random, 2), smooth),
          caseOf("two calls, one after the other", fresh(strip(random, 2)), smooth, 2),
          caseOf("two calls in a room with old colours", boxes(random, 0.7f, 1), smooth, 2)}},
        {"color.orphan",
         {caseOf("vertices that no patch uses", fresh(withOrphans(random, strip(random, 2))), smooth),
          caseOf("vertices that no patch uses, with old colours", withOrphans(random, strip(random, 2)), smooth),
          caseOf("vertices, but no patches", fresh(withOrphans(random, State{})), smooth)}},
        {"color.corners",
         {caseOf("quads and triangles", withFourthIndices(random, fresh(strip(random, 1))), smooth),
          caseOf("triangles alone", withFourthIndices(random, fresh(fan(random, 5, true))), smooth)}},
        {"color.rad",
         {caseOf("a strip of patches", fresh(strip(random, 2)), radiosity),
          caseOf("two calls in a room with old radiosities at the vertices", boxes(random, 0.7f, 1), radiosity, 2),
          caseOf("vertices that no patch uses", withOrphans(random, strip(random, 2)), radiosity)}},
        {"color.count",
         {caseOf("a strip of patches", fresh(strip(random, 2)), count),
          caseOf("two calls in a room with old counts", boxes(random, 0.7f, 1), count, 2),
          caseOf("vertices that no patch uses", withOrphans(random, strip(random, 2)), count)}},
    };
}

}  // namespace

std::vector<Check> colorChecks(std::uint64_t seed) {
    Random random(seed);
    std::vector<Check> all = flatChecks(random);
    for (Check& check : smoothChecks(random)) all.push_back(std::move(check));
    return all;
}

}  // namespace radlab::grader
