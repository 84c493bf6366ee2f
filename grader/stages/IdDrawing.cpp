#include "grader/stages/IdDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "grader/stages/Remembered.h"

namespace radlab::grader {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

// A colour is not sure where it is so near the middle between two bytes.
constexpr double roundingMargin = 2e-3;

// A line one pixel wide, or a point of one pixel, may colour pixels whose centres are so far away, in pixels.
constexpr double outlineReach = 1.6;

IdView viewOf(const Step& step, bool kept = true) {
    return {kept ? glm::dmat4(step.view) : glm::dmat4(1.0), 0, 0, step.width, step.height};
}

Fingerprint fingerprint(const State& state, const IdView& view, const RasterStyle& style) {
    Fingerprint key;
    key.addShape(state);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) key.add(static_cast<float>(view.clipFromWorld[column][row]));
    for (const int value : {view.width, view.height, static_cast<int>(style.depthTest), static_cast<int>(style.cull),
                            static_cast<int>(style.corners), static_cast<int>(style.reverse)})
        key.add(value);
    return key;
}

Outcome blank(const Situation& at) {
    Outcome outcome;
    outcome.state = at.before;
    const std::size_t pixels = static_cast<std::size_t>(at.step.width) * static_cast<std::size_t>(at.step.height);
    outcome.pixels.assign(pixels, 0.0);
    outcome.slack.assign(pixels, 0.0);
    return outcome;
}

void set(Outcome& outcome, std::size_t pixel, const Shade& shade) {
    outcome.pixels[pixel] = shade.packed();
    if (!shade.sure) outcome.slack[pixel] = unknown;
}

}  // namespace

int byteOf(double share, bool& sure) {
    const double scaled = 255.0 * std::clamp(share, 0.0, 1.0), fraction = scaled - std::floor(scaled);
    if (std::abs(fraction - 0.5) < roundingMargin) sure = false;
    return static_cast<int>(std::lround(scaled));
}

Shade shadeOf(std::uint32_t id) {
    return {static_cast<int>(id >> 16 & 255), static_cast<int>(id >> 8 & 255), static_cast<int>(id & 255)};
}

struct IdDrawer::Memory {
    Remembered<IdImage> images;
    Remembered<LayerImage> layers;
};

IdDrawer::IdDrawer() : memory(std::make_shared<Memory>()) {}
IdDrawer::~IdDrawer() = default;

Computation IdDrawer::draws(const IdDrawing& drawing) const {
    return [drawing, kept = memory](const Situation& at) {
        const Drawn other = drawing.drawn ? drawing.drawn(at.before) : Drawn{};
        const State& state = drawing.drawn ? other.state : at.before;
        const IdView view = viewOf(at.step, drawing.viewKept);
        const auto image = kept->images.get(fingerprint(state, view, drawing.style), [&] {
            return rasterIds(state, {&view, 1}, view.width, view.height, drawing.style);
        });
        Outcome outcome = blank(at);
        for (std::size_t pixel = 0; pixel < outcome.pixels.size(); ++pixel) {
            const int polygon = image->patch[pixel];
            const int patch = polygon >= 0 && drawing.drawn ? other.owner[static_cast<std::size_t>(polygon)] : polygon;
            set(outcome, pixel, patch < 0 ? drawing.background : drawing.shade(at.before, patch));
            if (!image->sure[pixel]) outcome.slack[pixel] = unknown;
        }
        return outcome;
    };
}

Computation IdDrawer::addsUp(const RasterStyle& style) const {
    return [style, kept = memory](const Situation& at) {
        const IdView view = viewOf(at.step);
        const auto image = kept->layers.get(fingerprint(at.before, view, style), [&] {
            return rasterLayers(at.before, {&view, 1}, view.width, view.height, style);
        });
        Outcome outcome = blank(at);
        for (std::size_t pixel = 0; pixel < outcome.pixels.size(); ++pixel) {
            Shade sum;
            for (const int patch : image->patchesOf(pixel)) {
                const Shade one = shadeOf(static_cast<std::uint32_t>(patch) + 1);
                sum.red = std::min(sum.red + one.red, 255);
                sum.green = std::min(sum.green + one.green, 255);
                sum.blue = std::min(sum.blue + one.blue, 255);
            }
            set(outcome, pixel, sum);
            if (!image->sure[pixel]) outcome.slack[pixel] = unknown;
        }
        return outcome;
    };
}

namespace {

// The patches whose outlines may colour a pixel.
class Outlines {
public:
    explicit Outlines(const Step& step)
        : width(step.width), height(step.height), view(step.view), ids(pixelCount(), 0) {}

    void draw(const State& state, std::size_t index, bool cornersOnly) {
        const MyPolygon& patch = state.patches[index];
        for (int i = 0; i < patch.vertices; ++i) {
            const glm::dvec2 from = onScreen(state, patch.vertex[i]);
            drawLine(from, cornersOnly ? from : onScreen(state, patch.vertex[(i + 1) % patch.vertices]), index + 1);
        }
    }

    /// The ID of one of them; 0 where there is none.
    std::size_t operator[](std::size_t pixel) const { return ids[pixel]; }

private:
    std::size_t pixelCount() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

    glm::dvec2 onScreen(const State& state, int corner) const {
        const glm::dvec4 clip =
            view * glm::dvec4(glm::dvec3(state.corners[static_cast<std::size_t>(corner)].position), 1.0);
        return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(width, height);
    }

    void drawLine(const glm::dvec2& from, const glm::dvec2& to, std::size_t id) {
        const glm::dvec2 low = glm::max(glm::min(from, to) - outlineReach - 0.5, glm::dvec2(0.0)),
                         high = glm::min(glm::max(from, to) + outlineReach - 0.5, glm::dvec2(width - 1, height - 1));
        const glm::dvec2 along = to - from;
        const double length2 = glm::dot(along, along);
        for (int y = static_cast<int>(std::ceil(low.y)); y <= high.y; ++y)
            for (int x = static_cast<int>(std::ceil(low.x)); x <= high.x; ++x) {
                const glm::dvec2 centre(x + 0.5, y + 0.5);
                const double t = length2 > 0.0 ? std::clamp(glm::dot(centre - from, along) / length2, 0.0, 1.0) : 0.0;
                if (glm::distance(centre, from + t * along) <= outlineReach)
                    ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
                        id;
            }
    }

    const int width, height;
    const glm::dmat4 view;
    std::vector<std::size_t> ids;
};

}  // namespace

Computation drawsOutlines(bool cornersOnly) {
    return [cornersOnly](const Situation& at) {
        Outcome outcome = blank(at);
        Outlines outlines(at.step);
        for (std::size_t i = 0; i < at.before.patches.size(); ++i) outlines.draw(at.before, i, cornersOnly);
        for (std::size_t pixel = 0; pixel < outcome.slack.size(); ++pixel) {
            if (outlines[pixel] == 0) continue;
            outcome.pixels[pixel] = static_cast<double>(outlines[pixel]);
            outcome.slack[pixel] = unknown;
        }
        return outcome;
    };
}

}  // namespace radlab::grader
