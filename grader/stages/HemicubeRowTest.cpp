#include "grader/stages/HemicubeRow.h"

#include <numeric>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "course/DeltaFormFactors.h"
#include "grader/stages/RasterTestHelp.h"

using namespace radlab;
using namespace radlab::grader;
using namespace radlab::grader::test;

namespace {

// The up vector that the solution takes.
Vec3f upOf(const State& state, const MyPolygon& patch) {
    return state.corners[static_cast<std::size_t>(patch.vertex[0])].position - patch.center;
}

HemicubeBuffer bufferAt(const State& state, std::size_t shooter, int size, const RasterStyle& style = {}) {
    const MyPolygon& patch = state.patches[shooter];
    return hemicubeBuffer(state, patch.center, upOf(state, patch), patch.normal, size, style);
}

std::vector<int> indices(const Hemicube& hemicube) {
    std::vector<int> found;
    for (int y = 0; y < hemicube.rendersize; ++y)
        for (int x = 0; x < hemicube.rendersize; ++x) found.push_back(hemicube.getIndex(x, y) - 1);
    return found;
}

// The row of the solution's calcFF.
std::vector<double> shoot(State& state, std::size_t shooter, Hemicube& hemicube) {
    for (MyPolygon& patch : state.patches) patch.unshot_rad = Vec3f(0);
    state.patches[shooter].unshot_rad = Vec3f(1);
    REQUIRE(calcFF(&hemicube) == &state.patches[shooter]);
    std::vector<double> row;
    for (const MyPolygon& patch : state.patches) row.push_back(patch.formF);
    return row;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

int outside(const Row& row, const std::vector<double>& found) {
    int count = 0;
    for (std::size_t i = 0; i < found.size(); ++i) count += std::abs(found[i] - row.values[i]) > row.slack[i];
    return count;
}

}  // namespace

TEST_CASE(
    "the buffer is the one that the course's Hemicube holds, and the row that of the solution, within the slack") {
    const auto context = GlContext::offscreen();
    for (const int size : {64, 256}) {
        CAPTURE(size);
        Hemicube hemicube(size);
        const std::vector<float> deltas = deltaFormFactors(size);
        double leastSure = 1.0, mostSlack = 0.0, largest = 0.0;
        for (unsigned seed = 1; seed <= 4; ++seed) {
            State state = furnishedRoom(seed, 0.07f);
            const Published published(state);
            for (std::size_t shooter = seed; shooter < state.patches.size(); shooter += 301) {
                CAPTURE(seed);
                CAPTURE(shooter);
                const HemicubeBuffer buffer = bufferAt(state, shooter, size);
                const Row row = hemicubeRow(buffer, deltas, state.patches.size());
                CHECK(outside(row, shoot(state, shooter, hemicube)) == 0);
                const Comparison found = compare(buffer.image, indices(hemicube));
                CHECK(found.sureAndWrong == 0);
                CHECK(found.notACandidate == 0);
                leastSure = std::min(leastSure, found.sureShare);
                mostSlack = std::max(mostSlack, sum(row.slack) / sum(row.values));
                largest = std::max(largest, *std::max_element(row.slack.begin(), row.slack.end()));
            }
        }
        MESSAGE("size " << size << ": least share of sure pixels " << leastSure << ", largest sum of slack "
                        << mostSlack << ", largest slack of a patch " << largest);
        CHECK(leastSure > 0.95);
        CHECK(mostSlack < (size == 64 ? 0.2 : 0.05));
    }
}

TEST_CASE("with the subpixel bits that OpenGL names, the slack is a hundredth of the row, and it is enough") {
    const auto context = GlContext::offscreen();
    RasterStyle style;
    glGetIntegerv(GL_SUBPIXEL_BITS, &style.subpixelBits);
    Hemicube hemicube(64);
    const std::vector<float> deltas = deltaFormFactors(64);
    double mostSlack = 0.0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        State state = furnishedRoom(seed, 0.1f);
        const Published published(state);
        for (std::size_t shooter = seed; shooter < state.patches.size(); shooter += 57) {
            CAPTURE(seed);
            CAPTURE(shooter);
            const Row row = hemicubeRow(bufferAt(state, shooter, 64, style), deltas, state.patches.size());
            CHECK(outside(row, shoot(state, shooter, hemicube)) == 0);
            mostSlack = std::max(mostSlack, sum(row.slack) / sum(row.values));
        }
    }
    MESSAGE("largest sum of slack with " << style.subpixelBits << " bits: " << mostSlack);
    CHECK(mostSlack < (style.subpixelBits >= 8 ? 0.02 : 0.2));
}

TEST_CASE("a row sums to 1 in a closed room, and the shooter does not see itself") {
    State state = furnishedRoom(3, 0.2f);
    for (std::size_t shooter = 0; shooter < state.patches.size(); shooter += 29) {
        const Row row = hemicubeRow(bufferAt(state, shooter, 64), deltaFormFactors(64), state.patches.size());
        CHECK(sum(row.values) == doctest::Approx(1.0).epsilon(1e-6));
        CHECK(row.values[shooter] == 0.0);
    }
}

TEST_CASE(
    "a row drawn without triangles or without a depth test is that of the same mistake in OpenGL, not the right "
    "one") {
    const auto context = GlContext::offscreen();
    State state = scatteredPatches(5, 200, 0.5f);
    const Published published(state);
    Hemicube hemicube(64);
    const std::vector<float> deltas = deltaFormFactors(64);
    const auto quadsOnly = [] {
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            if (polygons[i]->vertices != 4) continue;
            glBegin(GL_QUADS);
            glColor3ub(0, ((i + 1) >> 8) & 255, (i + 1) & 255);
            for (const int corner : polygons[i]->vertex) glVertex3fv(&vertices[corner]->position[0]);
            glEnd();
        }
    };
    const auto noDepth = [] {
        glDisable(GL_DEPTH_TEST);
        renderPatchIDs();
    };
    const std::vector<std::pair<RasterStyle, std::function<void()>>> mistakes = {
        {{.corners = RasterStyle::Corners::quadsOnly}, quadsOnly}, {{.depthTest = false}, noDepth}};
    for (const auto& [style, draw] : mistakes)
        for (std::size_t shooter = 0; shooter < state.patches.size(); shooter += 17) {
            CAPTURE(shooter);
            const MyPolygon& patch = state.patches[shooter];
            hemicube.renderScene(patch.center, upOf(state, patch), patch.normal, draw);
            hemicube.readIndexBuffer();
            std::vector<double> found(state.patches.size());
            const std::vector<int> shown = indices(hemicube);
            for (std::size_t pixel = 0; pixel < shown.size(); ++pixel)
                if (shown[pixel] >= 0) found[static_cast<std::size_t>(shown[pixel])] += deltas[pixel];
            const HemicubeBuffer wrong = bufferAt(state, shooter, 64, style);
            CHECK(compare(wrong.image, shown).sureAndWrong == 0);
            CHECK(outside(hemicubeRow(wrong, deltas, found.size()), found) == 0);
            CHECK(outside(hemicubeRow(bufferAt(state, shooter, 64), deltas, found.size()), found) >= 3);
        }
}

TEST_CASE("a pixel that is not sure counts in the slack of every patch that may win it, and of no other") {
    HemicubeBuffer buffer{2, {4, 4, std::vector<int>(16, -1), std::vector<std::uint8_t>(16, 1), {}, {1, 2, -1}}};
    buffer.image.start.assign(17, 3);
    std::fill_n(buffer.image.start.begin(), 6, 0);
    buffer.image.patch[5] = 1;
    buffer.image.sure[5] = 0;
    buffer.image.patch[6] = 0;
    const Row row = hemicubeRow(buffer, deltaFormFactors(2), 3);
    CHECK(row.values[0] == doctest::Approx(row.values[1]));
    CHECK(row.values[2] == 0.0);
    CHECK(row.slack[0] < 1e-6 * row.values[0]);
    CHECK(row.slack[1] == doctest::Approx(row.values[1]).epsilon(1e-5));
    CHECK(row.slack[2] == doctest::Approx(row.values[1]).epsilon(1e-5));
}

TEST_CASE("a sum in floats over any rectangle of pixels, in any order, lies within the slack") {
    for (const int size : {32, 128, 512}) {
        CAPTURE(size);
        const std::vector<float> deltas = deltaFormFactors(size);
        const int edge = 2 * size;
        std::mt19937 random(static_cast<unsigned>(size));
        std::uniform_int_distribution<int> place(0, edge - 1);
        const auto pixels = static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge);
        const auto pixelAt = [edge](int x, int y) {
            return static_cast<std::size_t>(y) * static_cast<std::size_t>(edge) + static_cast<std::size_t>(x);
        };
        HemicubeBuffer buffer{size, {edge, edge, {}, std::vector<std::uint8_t>(pixels, 1), {}, {}}};
        buffer.image.start.assign(pixels + 1, 0);
        for (int repeat = 0; repeat < 20; ++repeat) {
            const auto [left, right] = std::minmax({place(random), place(random)});
            const auto [bottom, top] = std::minmax({place(random), place(random)});
            buffer.image.patch.assign(pixels, -1);
            float byRows = 0.0f, byColumns = 0.0f;
            for (int y = bottom; y <= top; ++y)
                for (int x = left; x <= right; ++x) {
                    buffer.image.patch[pixelAt(x, y)] = 0;
                    byRows += deltas[pixelAt(x, y)];
                }
            for (int x = right; x >= left; --x)
                for (int y = top; y >= bottom; --y) byColumns += deltas[pixelAt(x, y)];
            const Row row = hemicubeRow(buffer, deltas, 1);
            CHECK(std::abs(byRows - row.values[0]) <= row.slack[0]);
            CHECK(std::abs(byColumns - row.values[0]) <= row.slack[0]);
            CHECK(row.slack[0] <= 5e-4 * row.values[0]);
        }
    }
}

TEST_CASE("vectors that give no frame are refused") {
    const State state = furnishedRoom(1, 0.5f);
    CHECK_THROWS_WITH_AS(hemicubeViews(state, Vec3f(0), Vec3f(0), Vec3f(0, 0, 1), 8), doctest::Contains("up vector"),
                         Error);
    CHECK_THROWS_WITH_AS(hemicubeViews(state, Vec3f(0), Vec3f(0, 0, 2), Vec3f(0, 0, 1), 8),
                         doctest::Contains("parallel"), Error);
    CHECK_THROWS_WITH_AS(hemicubeViews(state, Vec3f(0), Vec3f(0, 1, 0), Vec3f(0, NAN, 1), 8),
                         doctest::Contains("direction vector"), Error);
}
