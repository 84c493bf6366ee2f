#include "engine/PatchTree.h"

#include <doctest/doctest.h>

#include "engine/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

TEST_CASE("every patch is in the tree of its face, and clusters have the area of their patches") {
    for (const char* file : {"cornell_2.x3d", "l_room.x3d", "teapot.x3d"}) {
        CAPTURE(file);
        const CutScene cut(file, file[0] == 't' ? 0.5 : file[0] == 'l' ? 0.3 : 37.0);
        const PatchTree tree(cut.geometry);
        std::vector<double> whole(cut.scene.faces.size());
        for (std::size_t i = 0; i < tree.leaves(); ++i) {
            std::size_t top = i;
            while (tree.node(top).parent != PatchTree::none) top = tree.node(top).parent;
            CHECK(tree.shapes().faceOf[top] == cut.geometry.faceOf[i]);
            whole[tree.shapes().faceOf[top]] += tree.area(i);
        }
        for (const std::uint32_t root : tree.roots())
            CHECK(tree.area(root) == Approx(whole[tree.shapes().faceOf[root]]).epsilon(1e-12));
    }
}

TEST_CASE("clusters of a rectangle are rectangles, whatever the number of patches") {
    const CutScene cut("cornell_1.x3d", 41.0);
    const PatchTree tree(cut.geometry);
    for (std::size_t i = tree.leaves(); i < tree.size(); ++i) {
        const Polygon& outline = tree.shapes().patches[i];
        CHECK(outline.corners.size() == 4);
        CHECK(outline.area == Approx(tree.area(i)).epsilon(1e-5));
        CHECK(glm::length(outline.normal - cut.geometry.faces[tree.shapes().faceOf[i]].normal) < 1e-5);
    }
}

TEST_CASE("halves are balanced: a face of n patches has a tree of about log2 n levels") {
    const CutScene cut("cornell_1.x3d", 10.0);
    const PatchTree tree(cut.geometry);
    for (std::size_t i = 0; i < tree.leaves(); ++i) {
        int depth = 0;
        for (std::size_t top = i; tree.node(top).parent != PatchTree::none; top = tree.node(top).parent) ++depth;
        CHECK(depth <= 2 + 2 * std::log2(60.0));
    }
}

TEST_CASE("pulling takes means, pushing hands down: a constant stays a constant") {
    const CutScene cut("cornell_2.x3d", 80.0);
    const PatchTree tree(cut.geometry);
    std::vector<double> values(tree.size(), 0.0);
    std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(tree.leaves()), 3.0);
    tree.pull(values);
    for (const double value : values) CHECK(value == Approx(3.0).epsilon(1e-14));
    std::vector<double> handed(tree.size(), 0.0);
    for (const std::uint32_t root : tree.roots()) handed[root] = 2.0;
    tree.push(handed);
    for (std::size_t i = 0; i < tree.leaves(); ++i) CHECK(handed[i] == 2.0);
}

TEST_CASE("patches without area stay outside, and one alone is its face's tree") {
    Geometry geometry;
    const Polygon square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), line({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    geometry.faces = {square, line};
    geometry.patches = {square, line};
    geometry.faceOf = {0, 1};
    const PatchTree tree(geometry);
    CHECK(tree.roots() == std::vector<std::uint32_t>{0});
    CHECK(tree.size() == 2);
}
