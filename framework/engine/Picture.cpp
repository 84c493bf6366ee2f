#include "engine/Picture.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/Stopwatch.h"
#include "engine/Gather.h"
#include "engine/Parallel.h"

namespace radlab::engine {

namespace {

constexpr float colorTolerance = 0.03f;  // a difference that is smaller is shading

bool differ(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 off = glm::abs(a - b);
    const float most = std::max({a.r, a.g, a.b, b.r, b.g, b.b});
    return std::max({off.r, off.g, off.b}) > colorTolerance * most;
}

class Painter {
public:
    Painter(const TracedScene& tracedScene, const PatchShading& shading, const Frame& picture,
            const PictureOptions& chosen)
        : scene(tracedScene),
          gather(tracedScene, shading, picture.background, chosen.lobeSamples),
          camera(picture),
          options(chosen),
          width(picture.width),
          height(picture.height),
          image(width, height) {
        faces.resize(image.data().size());
        more.resize(image.data().size());
    }

    Image paint() {
        forAllPixels(width, height, options.progress, [&](int x, int y) {
            const Sample first = sample(x, y, 0.5, 0.5, 0);
            faces[index(x, y)] = first.face;
            more[index(x, y)] = first.seen.overLobe;
            image.at(x, y) = glm::vec3(first.seen.radiance);
        });
        if (options.antialiasing == Antialiasing::off || options.samplesPerEdge == 1) return std::move(image);
        stopped = !doneWhole([&] { sampleMore(); });
        return std::move(image);
    }

    bool stopped = false;

    std::atomic<std::size_t> sampledMore{0}, gathers{0};

private:
    void sampleMore() {
        forAllPixels(width, height, {}, [&](int x, int y) {
            if (options.antialiasing == Antialiasing::everywhere || isEdge(x, y)) more[index(x, y)] = true;
        });
        const Progress further = [&](std::size_t tiles) {
            if (options.progress) options.progress(tilesOf(width, height) + tiles);
        };
        forAllPixels(width, height, further, [&](int x, int y) {
            if (!more[index(x, y)]) return;
            image.at(x, y) = glm::vec3(mean(x, y));
            ++sampledMore;
        });
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    // Faces are flat, so that within one there is no edge of depth.
    bool isEdge(int x, int y) const {
        const auto differs = [&](int u, int v) {
            return u >= 0 && v >= 0 && u < width && v < height &&
                   (faces[index(u, v)] != faces[index(x, y)] || differ(image.at(u, v), image.at(x, y)));
        };
        return differs(x - 1, y) || differs(x + 1, y) || differs(x, y - 1) || differs(x, y + 1);
    }

    static constexpr std::uint32_t noFace = 0xffffffff;

    struct Sample {
        std::uint32_t face;
        Gathered seen;
    };

    Sample sample(int x, int y, double dx, double dy, int number) {
        Interrupts::check();
        const Point direction = camera.direction(x + dx, y + dy);
        const SurfacePoint first = scene.meet(camera.eye(), direction, RayHit::nothing, Sides::fronts);
        if (first.exists() && !scene.scattering(first.patch).isMatt()) ++gathers;
        return {first.exists() ? static_cast<std::uint32_t>(scene.faceOf()[first.patch]) : noFace,
                gather.radiance(first, direction, index(x, y), static_cast<std::size_t>(number))};
    }

    Point mean(int x, int y) {
        const int n = options.samplesPerEdge;
        const double step = 1.0 / n;
        Point sum(0.0);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum +=
                    sample(x, y, step * (i + step * (j + 0.5)), step * (j + step * (i + 0.5)), i * n + j).seen.radiance;
        return sum / static_cast<double>(n * n);
    }

    const TracedScene& scene;
    Gather gather;
    CameraRays camera;
    PictureOptions options;
    int width, height;
    Image image;
    std::vector<std::uint32_t> faces;  // that each pixel shows,
    std::vector<char> more;            // and whether it takes more than one ray
};

}  // namespace

Image drawPicture(const TracedScene& scene, const PatchShading& shading, const Frame& frame,
                  const PictureOptions& options, PictureReport* report) {
    RADLAB_CHECK(options.samplesPerEdge >= 1);
    RADLAB_CHECK(options.lobeSamples >= 1);
    const Stopwatch watch;
    const std::size_t before = scene.rays();
    Painter painter(scene, shading, frame, options);
    Image image = painter.paint();
    if (report)
        *report = {scene.rays() - before, painter.sampledMore, painter.gathers, watch.seconds(), painter.stopped};
    return image;
}

}  // namespace radlab::engine
