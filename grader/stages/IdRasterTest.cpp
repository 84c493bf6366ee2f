#include "grader/stages/IdRaster.h"

#include <doctest/doctest.h>

#include "grader/stages/RasterTestHelp.h"

using namespace radlab;
using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

const IdView whole{glm::dmat4(1.0), 0, 0, 512, 512};

Comparison compareWithOpenGl(State& state, const IdView& view, const RasterStyle& style = {},
                             const std::function<void()>& draw = renderPatchIDs) {
    const Published published(state);
    const std::vector<IdView> views = {view};
    return compare(rasterIds(state, views, 512, 512, style), drawn(views, 512, 512, draw));
}

int subpixelBits() {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return bits;
}

// A view straight onto the plane z = 0: one unit is one pixel, and (0, 0) the lower left corner.
IdView flatView(int width, int height) {
    return {glm::ortho(0.0, 1.0 * width, 0.0, 1.0 * height, -10.0, 10.0), 0, 0, width, height};
}

State rectangle(float left, float bottom, float right, float top, float z = 0.0f) {
    State state;
    addPatch(state, {{left, bottom, z}, {right, bottom, z}, {right, top, z}, {left, top, z}});
    return state;
}

void append(State& state, const State& more) {
    const int shift = static_cast<int>(state.corners.size());
    state.corners.insert(state.corners.end(), more.corners.begin(), more.corners.end());
    for (MyPolygon patch : more.patches) {
        for (int& corner : patch.vertex) corner += shift;
        state.patches.push_back(patch);
    }
}

void drawIds(const std::function<int(const MyPolygon&)>& cornersOf, bool reverse = false) {
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        const std::size_t i = reverse ? polygons.size() - 1 - k : k;
        const int corners = cornersOf(*polygons[i]);
        glBegin(corners == 4 ? GL_QUADS : GL_TRIANGLES);
        glColor3ub(((i + 1) >> 16) & 255, ((i + 1) >> 8) & 255, (i + 1) & 255);
        for (int corner = 0; corner < corners; ++corner)
            glVertex3fv(&vertices[polygons[i]->vertex[corner]]->position[0]);
        glEnd();
    }
}

// Weights of patches that add up without rounding: whole multiples of 2^-20.
glm::vec3 weight(int patch) {
    auto next = [state = static_cast<std::uint32_t>(patch) + 1u]() mutable {
        state = state * 747796405u + 2891336453u;
        return static_cast<float>(state >> 12) * 0x1p-20f;
    };
    const float red = next(), green = next(), blue = next();
    return {red, green, blue};
}

// The sums of weights that OpenGL blends in each pixel.
std::vector<glm::vec3> blended(const IdView& view, bool depthTest) {
    const SavedState saved;
    const Framebuffer framebuffer(view.width, view.height, Framebuffer::Color::floats);
    framebuffer.bind();
    setIdPassState();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!depthTest) glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glViewport(0, 0, view.width, view.height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(glm::value_ptr(view.clipFromWorld));
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        glBegin(polygons[i]->vertices == 4 ? GL_QUADS : GL_TRIANGLES);
        glColor3fv(glm::value_ptr(weight(static_cast<int>(i))));
        for (int corner = 0; corner < polygons[i]->vertices; ++corner)
            glVertex3fv(&vertices[polygons[i]->vertex[corner]]->position[0]);
        glEnd();
    }
    std::vector<glm::vec3> sums(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    glReadPixels(0, 0, view.width, view.height, GL_RGB, GL_FLOAT, sums.data());
    return sums;
}

}  // namespace

TEST_CASE("a pixel shows the patch that lies over its centre, and is sure of it 1/32 pixel away from the edge") {
    for (const float off : {0.03f, 0.04f, -0.03f, -0.04f}) {
        CAPTURE(off);
        const State state = rectangle(1.5f + off, 1.0f, 6.0f, 7.0f);
        const std::vector<IdView> views = {flatView(8, 8)};
        const IdImage image = rasterIds(state, views, 8, 8);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const auto pixel = 8 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x);
                const bool inside = x >= (off < 0.0f ? 1 : 2) && x < 6 && y >= 1 && y < 7;
                const bool onEdge = x == 1 && y >= 1 && y < 7 && std::abs(off) < 1.0f / 32;
                CHECK(image.patch[pixel] == (inside ? 0 : -1));
                CHECK(image.sure[pixel] == !onEdge);
                CHECK(image.candidatesOf(pixel).size() == (onEdge ? 2 : 0));
            }
    }
}

TEST_CASE("sure pixels are those of OpenGL, and others show one of the candidates: patches in random poses") {
    const auto context = GlContext::offscreen();
    double least = 1.0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        State state = scatteredPatches(seed, 300, 0.4f);
        const Comparison found = compareWithOpenGl(state, viewOf(Vec3f(0), 3.0, seed, whole));
        CHECK(found.sureAndWrong == 0);
        CHECK(found.notACandidate == 0);
        least = std::min(least, found.sureShare);
    }
    MESSAGE("least share of sure pixels: " << least);
    CHECK(least > 0.98);
}

TEST_CASE("sure pixels are those of OpenGL: a furnished room, also far from the origin") {
    const auto context = GlContext::offscreen();
    for (const float shift : {0.0f, 10.0f, 1000.0f}) {
        CAPTURE(shift);
        double least = 1.0;
        for (unsigned seed = 1; seed <= 4; ++seed) {
            CAPTURE(seed);
            State state = furnishedRoom(seed, 0.07f, Vec3f(shift));
            const IdView view = viewOf(Vec3f(shift + 0.5f), 0.4, seed, whole, 0.01);
            const Comparison found = compareWithOpenGl(state, view);
            CHECK(found.sureAndWrong == 0);
            CHECK(found.notACandidate == 0);
            least = std::min(least, found.sureShare);
        }
        MESSAGE("least share of sure pixels at " << shift << ": " << least);
        // A thousand units away floats leave 6e-5 of a unit, some hundredths of a pixel.
        CHECK(least > (shift < 100.0f ? 0.97 : 0.7));
    }
}

TEST_CASE("with the subpixel bits that OpenGL names, more pixels are sure, and rightly so") {
    const auto context = GlContext::offscreen();
    RasterStyle style;
    style.subpixelBits = subpixelBits();
    REQUIRE(style.subpixelBits >= 4);
    double least = 1.0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        State room = furnishedRoom(seed, 0.07f), scattered = scatteredPatches(seed, 300, 0.4f);
        for (const Comparison& found : {compareWithOpenGl(room, viewOf(Vec3f(0.5f), 0.4, seed, whole, 0.01), style),
                                        compareWithOpenGl(scattered, viewOf(Vec3f(0), 3.0, seed, whole), style)}) {
            CHECK(found.sureAndWrong == 0);
            CHECK(found.notACandidate == 0);
            least = std::min(least, found.sureShare);
        }
    }
    MESSAGE("least share of sure pixels with " << style.subpixelBits << " bits: " << least);
    CHECK(least > (style.subpixelBits >= 8 ? 0.995 : 0.97));
}

TEST_CASE("patches that the near plane cuts are drawn behind it, and only inside the viewport") {
    const auto context = GlContext::offscreen();
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        State state = scatteredPatches(seed, 3000, 0.2f);
        const IdView view = viewOf(Vec3f(0), 0.5, seed, {glm::dmat4(1.0), 10, 20, 300, 200}, 0.2);
        const Comparison found = compareWithOpenGl(state, view);
        CHECK(found.sureAndWrong == 0);
        CHECK(found.notACandidate == 0);
        CHECK(found.sureShare > 0.95);
    }
}

TEST_CASE("more than 65,536 patches keep their indices") {
    const auto context = GlContext::offscreen();
    radlab::test::Faces faces;
    faces.add({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    State state = stateOf(faces, 2.0f / 265);
    REQUIRE(state.patches.size() == 265 * 265);
    const Comparison found = compareWithOpenGl(state, viewOf(Vec3f(0), 2.2, 3, whole));
    CHECK(found.sureAndWrong == 0);
    CHECK(found.notACandidate == 0);
    MESSAGE("share of sure pixels with 70,225 patches on 512 x 512: " << found.sureShare);
    CHECK(found.sureShare > 0.93);
}

TEST_CASE("layers that nearly touch are sure only where 24 bits of depth tell them apart") {
    const auto context = GlContext::offscreen();
    for (unsigned seed = 1; seed <= 4; ++seed)
        for (const double distance : {2.0, 5.0}) {
            CAPTURE(seed);
            const State base = scatteredPatches(seed, 60, 0.8f);
            State state = base;
            for (const float gap : {1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f}) {
                State moved = base;
                for (const MyPolygon& patch : moved.patches)
                    for (int i = 0; i < patch.vertices; ++i)
                        moved.corners[static_cast<std::size_t>(patch.vertex[i])].position += gap * patch.normal;
                append(state, moved);
            }
            const Comparison found = compareWithOpenGl(state, viewOf(Vec3f(0), distance, seed, whole, 0.1));
            CHECK(found.sureAndWrong == 0);
            CHECK(found.notACandidate == 0);
        }
}

TEST_CASE("edges of what is hidden leave pixels sure") {
    const State wall = rectangle(2.1f, 2.1f, 60.1f, 60.1f, 1.0f);
    State both = rectangle(10.5f, 10.5f, 20.5f, 20.5f, 0.0f);
    append(both, wall);
    const std::vector<IdView> views = {flatView(64, 64)};
    CHECK(rasterIds(both, views, 64, 64).sure == rasterIds(wall, views, 64, 64).sure);
    RasterStyle noDepth;
    noDepth.depthTest = false;
    CHECK(rasterIds(both, views, 64, 64, noDepth).sure == rasterIds(wall, views, 64, 64).sure);
}

TEST_CASE("of two patches back to back either may be seen, unless one is culled") {
    const auto context = GlContext::offscreen();
    State state = rectangle(10.2f, 10.2f, 50.2f, 50.2f);
    State back = state;
    std::swap(back.patches[0].vertex[1], back.patches[0].vertex[3]);
    append(state, back);
    const std::vector<IdView> views = {flatView(64, 64)};
    const std::size_t middle = 64 * 32 + 32;
    const IdImage either = rasterIds(state, views, 64, 64);
    CHECK(!either.sure[middle]);
    CHECK(either.candidatesOf(middle).size() == 2);
    CHECK(either.patch[middle] == 0);
    for (const bool front : {false, true}) {
        RasterStyle style;
        style.cull = front ? RasterStyle::Cull::front : RasterStyle::Cull::back;
        const IdImage one = rasterIds(state, views, 64, 64, style);
        CHECK(one.sure[middle]);
        CHECK(one.patch[middle] == (front ? 1 : 0));
        const Published published(state);
        const Comparison found = compare(one, drawn(views, 64, 64, [front] {
                                             glEnable(GL_CULL_FACE);
                                             glCullFace(front ? GL_FRONT : GL_BACK);
                                             renderPatchIDs();
                                         }));
        CHECK(found.sureAndWrong == 0);
        CHECK(found.sureShare == 1.0);
    }
}

TEST_CASE("each mistake in drawing gives the picture that OpenGL gives with the same mistake") {
    const auto context = GlContext::offscreen();
    using Style = RasterStyle;
    struct Mistake {
        const char* name;
        RasterStyle style;
        std::function<void()> draw;
    };
    const auto asTold = [](const MyPolygon& patch) { return patch.vertices; };
    const std::vector<Mistake> mistakes = {
        {"no depth test", {.depthTest = false}, [] { glDisable(GL_DEPTH_TEST), renderPatchIDs(); }},
        {"backwards", {.reverse = true}, [=] { drawIds(asTold, true); }},
        {"backwards, no depth test",
         {.depthTest = false, .reverse = true},
         [=] { glDisable(GL_DEPTH_TEST), drawIds(asTold, true); }},
        {"backs culled",
         {.cull = Style::Cull::back},
         [] { glEnable(GL_CULL_FACE), glCullFace(GL_BACK), renderPatchIDs(); }},
        {"fronts culled",
         {.cull = Style::Cull::front},
         [] { glEnable(GL_CULL_FACE), glCullFace(GL_FRONT), renderPatchIDs(); }},
        {"quadrilaterals only",
         {.corners = Style::Corners::quadsOnly},
         [] { drawIds([](const MyPolygon& patch) { return patch.vertices == 4 ? 4 : 0; }); }},
        {"triangles only",
         {.corners = Style::Corners::trianglesOnly},
         [] { drawIds([](const MyPolygon& patch) { return patch.vertices == 3 ? 3 : 0; }); }},
        {"first three corners",
         {.corners = Style::Corners::firstThree},
         [] { drawIds([](const MyPolygon&) { return 3; }); }},
    };
    for (const Mistake& mistake : mistakes)
        for (unsigned seed = 1; seed <= 3; ++seed) {
            CAPTURE(mistake.name);
            CAPTURE(seed);
            State state = scatteredPatches(seed, 400, 0.4f);
            append(state, furnishedRoom(seed, 0.3f));
            const IdView view = viewOf(Vec3f(0.3f), 2.0, seed, whole);
            const Comparison found = compareWithOpenGl(state, view, mistake.style, mistake.draw);
            CHECK(found.sureAndWrong == 0);
            CHECK(found.notACandidate == 0);
            CHECK(found.sureShare > 0.95);
            if (mistake.style.depthTest && mistake.style.reverse) continue;  // not a mistake
            CHECK(compareWithOpenGl(state, view, {}, mistake.draw).sureAndWrong > 1000);
        }
}

TEST_CASE("patches seen edge-on, bent, concave, crossed or without area are never wrongly sure") {
    const auto context = GlContext::offscreen();
    for (unsigned seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> share(-1.0f, 1.0f);
        const auto vector = [&] { return Vec3f(share(random), share(random), share(random)); };
        State state;
        for (int i = 0; i < 40; ++i) {
            const Vec3f at = vector();
            addPatch(state, {at, at + 0.6f * vector(), at + 0.6f * vector(), at + 0.6f * vector()});
            const Vec3f along = 0.7f * vector();
            addPatch(state, {at, at + along, at + 1e-4f * vector()});
            addPatch(state, {at, at + along, at + along});
            addPatch(state, {at, at + along, at + along + 1e-3f * vector(), at + 1e-3f * vector()});
        }
        for (const RasterStyle::Cull cull : {RasterStyle::Cull::none, RasterStyle::Cull::back}) {
            RasterStyle style;
            style.cull = cull;
            const auto draw = [cull] {
                if (cull == RasterStyle::Cull::back) glEnable(GL_CULL_FACE);
                renderPatchIDs();
            };
            const Comparison found = compareWithOpenGl(state, viewOf(Vec3f(0), 2.0, seed, whole), style, draw);
            CHECK(found.sureAndWrong == 0);
            CHECK(found.notACandidate == 0);
            CHECK(found.sureShare > 0.4);
        }
    }
}

TEST_CASE("blended patches add up as in OpenGL: with a depth test those nearer than all before, without it all") {
    const auto context = GlContext::offscreen();
    for (const bool depthTest : {true, false})
        for (unsigned seed = 1; seed <= 4; ++seed) {
            CAPTURE(depthTest);
            CAPTURE(seed);
            State state = scatteredPatches(seed, 200, 0.4f);
            const Published published(state);
            const std::vector<IdView> views = {viewOf(Vec3f(0), 3.0, seed, whole)};
            RasterStyle style;
            style.depthTest = depthTest;
            const LayerImage image = rasterLayers(state, views, 512, 512, style);
            const std::vector<glm::vec3> found = blended(views[0], depthTest);
            int sure = 0, wrong = 0, deepest = 0;
            for (std::size_t pixel = 0; pixel < found.size(); ++pixel) {
                if (!image.sure[pixel]) continue;
                glm::vec3 sum(0.0f);
                for (const int patch : image.patchesOf(pixel)) sum += weight(patch);
                ++sure;
                wrong += sum != found[pixel];
                deepest = std::max(deepest, static_cast<int>(image.patchesOf(pixel).size()));
            }
            CHECK(wrong == 0);
            CHECK(sure > 0.95 * 512 * 512);
            CHECK(deepest >= 3);
        }
}

TEST_CASE("layers name what passes in the order in which it is drawn") {
    State state = rectangle(0, 0, 8, 8, 0);
    append(state, rectangle(0, 0, 8, 8, 2));
    append(state, rectangle(0, 0, 8, 8, 1));
    append(state, rectangle(0, 0, 8, 8, 3));
    const std::vector<IdView> views = {flatView(8, 8)};
    const auto layers = [&](const RasterStyle& style) {
        const LayerImage image = rasterLayers(state, views, 8, 8, style);
        CHECK(image.sure[27]);
        const auto found = image.patchesOf(27);
        return std::vector<int>(found.begin(), found.end());
    };
    CHECK(layers({}) == std::vector<int>{0, 1, 3});
    CHECK(layers({.depthTest = false}) == std::vector<int>{0, 1, 2, 3});
    CHECK(layers({.reverse = true}) == std::vector<int>{3});
    CHECK(layers({.depthTest = false, .reverse = true}) == std::vector<int>{3, 2, 1, 0});
}

TEST_CASE("no patches leave the background, and broken states or views are refused") {
    const std::vector<IdView> views = {flatView(8, 8)};
    const IdImage image = rasterIds({}, views, 8, 8);
    CHECK(image.patch == std::vector<int>(64, -1));
    CHECK(image.sure == std::vector<std::uint8_t>(64, 1));
    State state = rectangle(0, 0, 8, 8);
    CHECK_THROWS_AS(rasterIds(state, views, 7, 8), std::logic_error);
    state.patches[0].vertex[2] = 4;
    CHECK_THROWS_AS(rasterIds(state, views, 8, 8), std::logic_error);
    state.patches[0].vertices = 5;
    CHECK_THROWS_AS(rasterIds(state, views, 8, 8), std::logic_error);
}
