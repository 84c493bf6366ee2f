#include "grader/stages/PatchIdMistakes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace radlab::grader {

namespace {

using Cull = RasterStyle::Cull;
using Corners = RasterStyle::Corners;

// The colour that follows from a patch's ID alone.
Computation colors(const IdDrawer& drawer, const std::function<Shade(std::uint32_t id)>& shade) {
    IdDrawing drawing;
    drawing.shade = [shade](const State&, int patch) { return shade(static_cast<std::uint32_t>(patch) + 1); };
    return drawer.draws(drawing);
}

// The colour whose bytes each are changed in the same way.
Computation bytes(const IdDrawer& drawer, const std::function<int(int byte, bool& sure)>& change) {
    return colors(drawer, [change](std::uint32_t id) {
        Shade shade = shadeOf(id);
        for (int* byte : {&shade.red, &shade.green, &shade.blue}) *byte = change(*byte, shade.sure);
        return shade;
    });
}

Computation styled(const IdDrawer& drawer, const RasterStyle& style) {
    IdDrawing drawing;
    drawing.style = style;
    return drawer.draws(drawing);
}

std::vector<Mistake> counting(const IdDrawer& drawer) {
    const std::string zero =
        "0 is the background: with IDs that do not begin at 1, calcFF adds to the wrong patch, or cannot tell the "
        "first patch from nothing.";
    return {
        {"ids-from-zero", "The ID is the index i, not i + 1. " + zero,
         "Which ID has polygons[0], and what else is black?",
         colors(drawer, [](std::uint32_t id) { return shadeOf(id - 1); })},
        {"ids-from-two", "The ID is i + 2: 1 is added once too often. " + zero, "Which ID has polygons[0]?",
         colors(drawer, [](std::uint32_t id) { return shadeOf(id + 1); })},
    };
}

std::vector<Mistake> byteOrders(const IdDrawer& drawer) {
    std::vector<Mistake> all;
    const auto order = [&](const std::string& id, const std::string& text, const std::array<int, 3>& from) {
        all.push_back(
            {id, text, "Which of the three bytes changes most slowly from patch to patch, and which colour is that?",
             colors(drawer, [from](std::uint32_t value) {
                 const Shade right = shadeOf(value);
                 const std::array<int, 3> byte = {right.red, right.green, right.blue};
                 return Shade{byte[static_cast<std::size_t>(from[0])], byte[static_cast<std::size_t>(from[1])],
                              byte[static_cast<std::size_t>(from[2])]};
             })});
    };
    order("bgr",
          "The low byte is in red and the high byte in blue. getIndex reads red as the high byte: it would find patch "
          "65,536 for patch 1.",
          {2, 1, 0});
    for (const std::array<int, 3>& from :
         {std::array{0, 2, 1}, std::array{1, 0, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}})
        order("byte-order",
              "The three bytes of the ID are in the wrong colours: red is the high one, blue the low one.", from);
    return all;
}

std::vector<Mistake> lostBytes(const IdDrawer& drawer) {
    const std::string one =
        "One byte counts to 255 only: from the 256th patch on, several share a colour, and their light goes to one "
        "of them.";
    const std::string hint = "What is the ID of a patch whose colour is (1, 2, 3)?";
    const auto low = [](std::uint32_t id) { return static_cast<int>(id & 255); };
    return {
        {"one-byte", "The whole ID is put into blue, and what does not fit is lost. " + one, hint,
         colors(drawer,
                [low](std::uint32_t id) {
                    return Shade{0, 0, low(id)};
                })},
        {"one-byte", "The whole ID is put into red, and what does not fit is lost. " + one, hint,
         colors(drawer,
                [low](std::uint32_t id) {
                    return Shade{low(id), 0, 0};
                })},
        {"one-byte", "Red, green and blue are the same byte. " + one, hint,
         colors(drawer,
                [low](std::uint32_t id) {
                    return Shade{low(id), low(id), low(id)};
                })},
        {"two-bytes",
         "The high byte is missing: IDs begin anew after 65,535. Scenes with small patches have more than that.",
         "How many bits of the ID are in your colour? Which are lost?",
         colors(drawer, [](std::uint32_t id) { return shadeOf(id & 0xffff); })},
        {"two-bytes",
         "The ID is put into red and green, as if it had two bytes: blue stays 0, and getIndex finds IDs that are 256 "
         "times too large.",
         "Which colour is the low byte?", colors(drawer, [](std::uint32_t id) { return shadeOf((id & 0xffff) << 8); })},
        {"signed-16-bit",
         "The ID goes through a number with 16 bits and a sign: above 32,767 it becomes negative, and red is 255.",
         "What is the largest value of a short?",
         colors(drawer,
                [](std::uint32_t id) {
                    const auto narrow = static_cast<std::int16_t>(id);
                    return shadeOf(static_cast<std::uint32_t>(static_cast<std::int32_t>(narrow)));
                })},
        {"seven-bits", "Each byte is cut to 7 bits, so that half the IDs have the colour of another one.",
         "How large is a mask that keeps all 8 bits of a byte?",
         bytes(drawer, [](int byte, bool&) { return byte & 127; })},
        {"seven-bits",
         "The ID is taken apart by 7 bits, not 8. getIndex puts it together by 256, and finds another patch.",
         "By how many bits are the bytes of a number apart?",
         colors(drawer,
                [](std::uint32_t id) {
                    return Shade{static_cast<int>(id >> 14 & 127), static_cast<int>(id >> 7 & 127),
                                 static_cast<int>(id & 127)};
                })},
        {"base-255",
         "The ID is taken apart by 255: that is the largest byte, but a byte has 256 values. The 255th patch already "
         "gets "
         "another ID.",
         "How many values has a byte?",
         colors(drawer,
                [](std::uint32_t id) {
                    return Shade{static_cast<int>(id / 65025 % 255), static_cast<int>(id / 255 % 255),
                                 static_cast<int>(id % 255)};
                })},
    };
}

// A byte that is rounded, not cut off, to the nearest multiple of what lies below it.
int rounded(double value, bool& sure) { return byteOf(value / 255.0, sure); }

std::vector<Mistake> rounding(const IdDrawer& drawer) {
    const std::string carry =
        "A higher byte is rounded, not cut off: where the byte below is 128 or more, it is 1 too large, and the ID "
        "points to "
        "a patch far away.";
    const std::string carryHint = "What should the middle byte of 255 be, and what does 255 / 256.0 round to?";
    const auto carrying = [&](bool high, bool middle) {
        return colors(drawer, [=](std::uint32_t id) {
            Shade shade = shadeOf(id);
            if (high) shade.red = rounded(id / 65536.0, shade.sure);
            if (middle) shade.green = rounded(id % 65536 / 256.0, shade.sure);
            return shade;
        });
    };
    return {
        {"byte-carry", carry, carryHint, carrying(true, true)},
        {"byte-carry", carry, carryHint, carrying(false, true)},
        {"byte-carry", carry, carryHint, carrying(true, false)},
        {"divided-by-256",
         "Colours as floats go from 0 to 1, and 1 is the byte 255: divided by 256, bytes above 128 come out 1 too "
         "small.",
         "Which float is the byte 255, and what does it become if you divide it by 256?",
         bytes(drawer, [](int byte, bool& sure) { return byteOf(byte / 256.0, sure); })},
        {"bytes-not-scaled",
         "Bytes are given to a function that takes floats from 0 to 1: every byte above 0 is cut to 1, which is 255.",
         "What does the ending of a glColor function say about its values?",
         bytes(drawer, [](int byte, bool&) { return byte > 0 ? 255 : 0; })},
        {"signed-bytes",
         "glColor3b takes bytes with a sign, from -128 to 127: 127 is full brightness, and above that a byte is "
         "negative.",
         "What do the letters b and ub at the end of glColor3 mean?",
         bytes(drawer, [](int byte, bool&) { return byte < 128 ? 2 * byte + 1 : 0; })},
    };
}

Computation shares(const IdDrawer& drawer, bool grey) {
    IdDrawing drawing;
    drawing.shade = [grey](const State& state, int patch) {
        Shade shade;
        shade.red = byteOf((patch + 1) / static_cast<double>(state.patches.size()), shade.sure);
        if (grey) shade.green = shade.blue = shade.red;
        return shade;
    };
    return drawer.draws(drawing);
}

Computation memberColors(const IdDrawer& drawer, Vec3f MyPolygon::*member) {
    IdDrawing drawing;
    drawing.shade = [member](const State& state, int patch) {
        const Vec3f& color = state.patches[static_cast<std::size_t>(patch)].*member;
        Shade shade;
        shade.red = byteOf(static_cast<double>(color.x), shade.sure);
        shade.green = byteOf(static_cast<double>(color.y), shade.sure);
        shade.blue = byteOf(static_cast<double>(color.z), shade.sure);
        return shade;
    };
    return drawer.draws(drawing);
}

std::vector<Mistake> otherColors(const IdDrawer& drawer) {
    const std::string one = "glColor sets the colour of the corners that follow, not of those before.";
    std::vector<Mistake> all = {
        {"color-after-corners",
         "The colour is set after the corners, so each patch has the ID of the one before it, and the first has the "
         "white "
         "that OpenGL starts with. " +
             one,
         "Which colour is current when the last corner of a patch is given?",
         colors(drawer,
                [](std::uint32_t id) {
                    return id == 1 ? Shade{255, 255, 255} : shadeOf(id - 1);
                })},
        {"color-missing", "All patches are white: no colour is set.", "Which call sets the colour of a patch?",
         colors(drawer,
                [](std::uint32_t) {
                    return Shade{255, 255, 255};
                })},
        {"lighting",
         "Lighting is switched on: OpenGL then computes colours from its lights and materials, and the ID is ignored.",
         "The drawing state is set already: which of your calls change it?",
         colors(drawer,
                [](std::uint32_t) {
                    return Shade{10, 10, 10};
                })},
        {"id-as-share",
         "The ID is divided by the number of patches, to make it a brightness. A byte has 256 values, so patches share "
         "theirs, and getIndex does not know the factor.",
         "How does getIndex find the ID in a colour?", shares(drawer, true)},
        {"id-as-share",
         "The ID is divided by the number of patches, to make it a brightness of red. A byte has 256 values, so "
         "patches "
         "share theirs, and getIndex does not know the factor.",
         "How does getIndex find the ID in a colour?", shares(drawer, false)},
    };
    for (Vec3f MyPolygon::*member : {&MyPolygon::color, &MyPolygon::diffuse, &MyPolygon::emissive, &MyPolygon::rad})
        all.push_back(
            {"patch-color",
             "The patches are drawn in a colour of their own, as for looking at them. Here, the colour must tell "
             "which patch it is.",
             "What is read back from a pixel, and what for?", memberColors(drawer, member)});
    return all;
}

Drawn without(const State& state, const std::function<bool(std::size_t patch)>& left) {
    Drawn drawn{{{}, state.corners}, {}};
    for (std::size_t i = 0; i < state.patches.size(); ++i) {
        if (left(i)) continue;
        drawn.state.patches.push_back(state.patches[i]);
        drawn.owner.push_back(static_cast<int>(i));
    }
    return drawn;
}

Computation drawsInstead(const IdDrawer& drawer, const std::function<Drawn(const State&)>& what) {
    IdDrawing drawing;
    drawing.drawn = what;
    return drawer.draws(drawing);
}

std::vector<Mistake> lostPatches(const IdDrawer& drawer) {
    std::vector<Mistake> all = {
        {"nothing-drawn", "Nothing is to be seen: the picture is all background.",
         "Does each patch have its glBegin and glEnd, its corners in between, and a colour that is not black?",
         colors(drawer, [](std::uint32_t) { return Shade{}; })},
        {"first-patch-lost", "polygons[0] is not drawn. It has the ID 1, since 0 is the background.",
         "Which value does your loop begin with?",
         drawsInstead(drawer, [](const State& state) { return without(state, [](std::size_t i) { return i == 0; }); })},
        {"last-patch-lost", "The last patch is not drawn.", "At which value does your loop end?",
         drawsInstead(drawer,
                      [](const State& state) {
                          return without(state, [&](std::size_t i) { return i + 1 == state.patches.size(); });
                      })},
    };
    for (const std::size_t count : {255u, 256u, 65535u, 65536u})
        all.push_back({"first-patches-only", "Only as many patches are drawn as one or two bytes can count.",
                       "Where does your code limit how many patches there may be?",
                       drawsInstead(drawer, [count](const State& state) {
                           return without(state, [count](std::size_t i) { return i >= count; });
                       })});
    return all;
}

// All corners in one row, taken `size` at a time; OpenGL takes the colour of the last of them.
Drawn inOneRow(const State& state, int size) {
    Drawn drawn{{{}, state.corners}, {}};
    MyPolygon next;
    for (std::size_t i = 0; i < state.patches.size(); ++i)
        for (int k = 0; k < state.patches[i].vertices; ++k) {
            next.vertex[next.vertices++] = state.patches[i].vertex[k];
            if (next.vertices < size) continue;
            drawn.state.patches.push_back(next);
            drawn.owner.push_back(static_cast<int>(i));
            next = MyPolygon();
        }
    return drawn;
}

// The two triangles of a strip that goes round a quadrilateral as if it zigzagged.
Drawn asStrips(const State& state) {
    Drawn drawn{{{}, state.corners}, {}};
    for (std::size_t i = 0; i < state.patches.size(); ++i)
        for (int k = 0; k + 2 < state.patches[i].vertices; ++k) {
            MyPolygon part;
            part.vertices = 3;
            std::copy_n(state.patches[i].vertex + k, 3, part.vertex);
            drawn.state.patches.push_back(part);
            drawn.owner.push_back(static_cast<int>(i));
        }
    return drawn;
}

Drawn crossed(const State& state) {
    Drawn drawn = without(state, [](std::size_t) { return false; });
    for (MyPolygon& patch : drawn.state.patches)
        if (patch.vertices == 4) std::swap(patch.vertex[2], patch.vertex[3]);
    return drawn;
}

std::vector<Mistake> shapes(const IdDrawer& drawer) {
    RasterStyle quads, triangles, three;
    quads.corners = Corners::quadsOnly;
    triangles.corners = Corners::trianglesOnly;
    three.corners = Corners::firstThree;
    const std::string kinds = "patch->vertices says how many corners a patch has: 3 or 4.";
    const std::string order =
        "The corners of a patch go round it, counter-clockwise. A strip, which zigzags, needs them in another order, "
        "and "
        "makes a bow tie of them.";
    const std::string orderHint =
        "Draw a square, number its corners, and join them in the order in which you give them.";
    return {
        {"triangles-lost",
         "Triangles are missing: three corners between glBegin(GL_QUADS) and glEnd draw nothing. " + kinds,
         "What do you tell glBegin for a patch with three corners?", styled(drawer, quads)},
        {"quadrilaterals-lost", "Quadrilaterals are missing. " + kinds,
         "What do you tell glBegin for a patch with four corners?", styled(drawer, triangles)},
        {"fourth-corner-lost", "Of a quadrilateral only the triangle of its first three corners is drawn. " + kinds,
         "What does GL_TRIANGLES do with a fourth corner?", styled(drawer, three)},
        {"corners-in-one-row",
         "Triangles and quadrilaterals share one glBegin, which takes four corners at a time: after the first "
         "triangle, "
         "the corners of different patches are joined. " +
             kinds,
         "What does glBegin(GL_QUADS) do with 3 + 4 + 4 corners?",
         drawsInstead(drawer, [](const State& state) { return inOneRow(state, 4); })},
        {"corners-in-one-row",
         "Triangles and quadrilaterals share one glBegin, which takes three corners at a time: after the first "
         "quadrilateral, the corners of different patches are joined. " +
             kinds,
         "What does glBegin(GL_TRIANGLES) do with 4 + 3 + 3 corners?",
         drawsInstead(drawer, [](const State& state) { return inOneRow(state, 3); })},
        {"corner-order", order, orderHint, drawsInstead(drawer, asStrips)},
        {"corner-order", order, orderHint, drawsInstead(drawer, crossed)},
    };
}

std::vector<Mistake> drawingState(const IdDrawer& drawer) {
    RasterStyle back, front, noDepth, reversed;
    back.cull = Cull::back;
    front.cull = Cull::front;
    noDepth.depthTest = false;
    reversed.depthTest = false;
    reversed.reverse = true;
    const std::string culled =
        "Patches are left out by the side that they show. But a patch blocks light with its back, too: what lies "
        "behind "
        "it would be lit through it.";
    const std::string depth =
        "The depth test is off: the patch that is drawn last is seen, not the nearest one, so light goes through "
        "walls.";
    const std::string state = "The drawing state is set already: which of your calls change it?";
    IdDrawing white, worldOnly;
    white.background = {255, 255, 255};
    worldOnly.viewKept = false;
    return {
        {"background-white",
         "The background is cleared to white. It must stay 0, which is no patch's ID; and the hemicube's buffer is "
         "cleared already.",
         state, drawer.draws(white)},
        {"backs-culled", culled, state, styled(drawer, back)},
        {"fronts-culled", culled, state, styled(drawer, front)},
        {"depth-test-off", depth, state, styled(drawer, noDepth)},
        {"depth-test-off", depth, state, styled(drawer, reversed)},
        {"blending",
         "Blending is on: a patch drawn over another one adds its ID to the other's, and the sum is the ID of a third.",
         state, drawer.addsUp({})},
        {"blending",
         "Blending is on and the depth test off: the IDs of all patches at a pixel are added up, and the sum is the ID "
         "of another one.",
         state, drawer.addsUp(noDepth)},
        {"camera-reset",
         "The matrices are set to the identity, so the camera that the hemicube has chosen is lost: every view shows "
         "the "
         "same.",
         "Who knows where the camera stands, and when is its matrix set?", drawer.draws(worldOnly)},
        {"corners-only", "Only the corners of patches are drawn, as points: in between, light would go through.",
         "What does glBegin need to be told so that areas are filled?", drawsOutlines(true)},
        {"outlines-only", "Only the outlines of patches are drawn, as lines: in between, light would go through.",
         "What makes OpenGL fill a polygon?", drawsOutlines(false)},
    };
}

}  // namespace

std::vector<Mistake> patchIdMistakes(const IdDrawer& drawer) {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some :
         {counting(drawer), byteOrders(drawer), lostBytes(drawer), rounding(drawer), otherColors(drawer),
          lostPatches(drawer), shapes(drawer), drawingState(drawer)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader
