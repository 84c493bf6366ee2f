#include "apps/DemoSteps.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "base/ProgressBar.h"
#include "base/Warning.h"
#include "course/ProgRef.h"
#include "display/Draw.h"
#include "display/FalseColor.h"
#include "display/Label.h"
#include "display/ToneMap.h"
#include "scene/ResourceFile.h"
#include "scene/X3dReader.h"
#include "solver/FormFactors.h"
#include "solver/Progressive.h"

namespace radlab {

namespace {

constexpr int pictureSize = 800;
constexpr int stripShots = 5;
constexpr double convergedShare = 0.02;
constexpr int mostShots = 20000;

std::string withCommas(long long number) {
    std::string digits = std::to_string(number);
    for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3)
        digits.insert(static_cast<std::size_t>(place), ",");
    return digits;
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, share < 0.1 ? "%.2g %%" : "%.0f %%", 100.0 * share);
    return text;
}

std::string decimal(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

// A scene with its settings and patches, ready to be solved and drawn.
struct Setting {
    explicit Setting(const std::filesystem::path& file)
        : resource(readResource(file)),
          scene(readX3d(resource.sceneFile)),
          mesh(scene.vertices, scene.faces, resource.patchSize, resource.lightSize) {
        view.width = view.height = pictureSize;
        view.background = scene.background;
        if (!scene.cameras.empty()) view.camera = scene.cameras.front();
        if (std::none_of(scene.faces.begin(), scene.faces.end(), [](const Face& f) { return f.material->emits(); }))
            warn(scene.file + ": nothing emits light, so all pictures of it are black");
    }

    std::string name() const { return resource.sceneFile.filename().string(); }
    std::string patchCount() const { return withCommas(static_cast<long long>(mesh.patches.size())) + " patches"; }

    Resource resource;
    Scene scene;
    PatchMesh mesh;
    View view;
};

Image notWrittenYet(const std::string& function) {
    Image image(pictureSize, pictureSize, glm::vec3(0.16f, 0.17f, 0.2f));
    const std::string first = function, second = "is not written yet";
    writeText(image, (pictureSize - textWidth(first, 5)) / 2, 340, first, 5, glm::vec3(1.0f, 0.8f, 0.4f));
    writeText(image, (pictureSize - textWidth(second, 3)) / 2, 410, second, 3, glm::vec3(0.8f));
    return image;
}

float unshotPower(const MyPolygon& patch) { return length(patch.unshot_rad) * patch.area; }

class DemoMaker {
public:
    DemoMaker(const std::filesystem::path& empty, const std::filesystem::path& furnished,
              std::function<void(const DemoPicture&)> onPicture)
        : plain(empty), blocks(furnished), report(std::move(onPicture)) {}

    Demo make() {
        const Stopwatch watch;
        meshPicture();
        brightestPicture();
        analyticFormFactors();
        firstShots();
        convergedAnalytic();
        idPicture();
        hemicubePicture();
        hemicubeFormFactors();
        shadows();
        demo.seconds = watch.seconds();
        return std::move(demo);
    }

private:
    // Adds a picture; a stub on the way ends in a picture that names it.
    void add(DemoPicture picture, const std::function<Image(DemoPicture&)>& draw) {
        try {
            picture.image = draw(picture);
        } catch (const NotImplemented& stub) {
            picture.image = notWrittenYet(stub.function());
            picture.written = false;
            picture.text =
                stub.function() + " is not written yet. Write it in exercises/ProgRef.cpp and run the demo again.";
        }
        report(picture);
        demo.pictures.push_back(std::move(picture));
    }

    static Progressive shotsOf(Setting& setting) {
        const FormFactorMethod method = formFactorMethod(setting.resource, setting.scene);
        return {setting.mesh, formFactorsBy(method, setting.resource.hemicubeSize)};
    }

    void meshPicture() {
        add({"01_patches.png", "The scene is cut into patches", "patches", "", "", {}}, [this](DemoPicture& picture) {
            plain.mesh.publish();
            picture.text = plain.name() + " is cut into " + plain.patchCount() +
                           ". Each is taken to have one radiosity all over. "
                           "Patches of one face share their vertices, so colours can be smoothed over a face, but "
                           "never across an edge.";
            return drawWireframe(plain.view);
        });
    }

    void brightestPicture() {
        add({"02_brightest.png",
             "Stage 1: the patch with the most unshot power",
             "1 maxenergy_patch",
             "maxenergy_patch",
             "",
             {}},
            [this](DemoPicture& picture) {
                plain.mesh.publish();
                plain.mesh.reset();
                const int shots = afterTheLight(plain);
                const MyPolygon* brightest = maxenergy_patch();
                if (!brightest) throw Error({plain.scene.file}, "maxenergy_patch found no patch");
                const float most = unshotPower(*brightest);
                picture.text =
                    "Unshot power, from black to pale yellow, " +
                    (shots > 0 ? "after " + std::to_string(shots) + " shots from the light"
                               : std::string("before the first shot")) +
                    ". The patch with the most, in green, shoots next: this order makes the picture good early.";
                return drawColors(plain.view, [=](std::size_t i) {
                    return polygons[i] == brightest ? glm::vec3(0.1f, 0.9f, 0.3f)
                                                    : heatColor(unshotPower(*polygons[i]) / most);
                });
            });
    }

    // Shoots all patches of the light, where stages 2 and 3 are written; else leaves the scene as it is.
    int afterTheLight(Setting& setting) {
        const auto lights = std::count_if(polygons.begin(), polygons.end(),
                                          [](const MyPolygon* p) { return p->emissive != Vec3f(0.0f); });
        Progressive solver = shotsOf(setting);
        try {
            while (solver.progress().shots < lights && solver.shoot()) {
            }
        } catch (const NotImplemented&) {
            setting.mesh.reset();
        }
        return solver.progress().shots;
    }

    void analyticFormFactors() {
        add({"03_analytic_form_factors.png",
             "Stage 2: form factors by formula",
             "2 calcAnalyticalFF",
             "calcAnalyticalFF",
             "",
             {}},
            [this](DemoPicture& picture) {
                plain.mesh.publish();
                plain.mesh.reset();
                const MyPolygon* shooter = calcAnalyticalFF();
                picture.text =
                    "Form factors from one patch of the light to every other patch, on a logarithmic scale, in a room "
                    "without "
                    "blocks. They sum to " +
                    decimal(sumOfFormFactors(), 3) +
                    "; what is missing to 1 leaves through the open front. The formula sees nothing that stands in "
                    "between.";
                return formFactorPicture(plain, shooter);
            });
    }

    static double sumOfFormFactors() {
        double sum = 0.0;
        for (const MyPolygon* patch : polygons) sum += static_cast<double>(patch->formF);
        return sum;
    }

    static Image formFactorPicture(const Setting& setting, const MyPolygon* shooter) {
        return drawColors(setting.view, [shooter](std::size_t i) {
            return polygons[i] == shooter ? glm::vec3(0.1f, 0.9f, 0.3f) : formFactorColor(polygons[i]->formF);
        });
    }

    void firstShots() {
        add({"04_first_shots.png",
             "Stage 3: the first shots",
             "3 distributeEnergy, first shots",
             "distributeEnergy",
             "",
             {}},
            [this](DemoPicture& picture) {
                plain.mesh.publish();
                plain.mesh.reset();
                const int shots = afterTheLight(plain);
                if (shots == 0) distributeEnergy(maxenergy_patch());
                colorReconstruction();
                const Image radiance = drawRadiance(plain.view, Shading::flat);
                picture.text = "After " + std::to_string(shots) +
                               " shots all patches of the light have shot once: this is direct light. "
                               "The ceiling is black, since nothing has reached it yet.";
                return toneMap(radiance, autoExposure(radiance));
            });
    }

    void convergedAnalytic() {
        Image smooth;
        std::string figures;
        add({"05_flat.png", "Stages 3 and 4: converged, flat", "3 + 4 converged, flat", "colorReconstruction", "", {}},
            [&](DemoPicture& picture) {
                const Progress progress = solve(plain, "analytic", {});
                const Image radiance = drawRadiance(plain.view, Shading::flat);
                const float exposure = autoExposure(radiance);
                smooth = toneMap(drawRadiance(plain.view, Shading::smooth), exposure);
                figures = withCommas(progress.shots) + " shots in " + durationText(progress.seconds);
                picture.text =
                    "After " + figures + ", " + percent(progress.unshotShare) +
                    " of the light's power is still unshot. Light that bounced off the red and green walls colours the "
                    "floor, the ceiling and the back wall near them. Every patch has its radiance, rad / pi.";
                return toneMap(radiance, exposure);
            });
        add({"06_smooth.png",
             "Stage 4: the same, smooth",
             "4 colorReconstruction, smooth",
             "colorReconstruction",
             "",
             {}},
            [&](DemoPicture& picture) {
                if (smooth.empty())
                    throw NotImplemented(demo.pictures.back().text.substr(0, demo.pictures.back().text.find(' ')));
                picture.text =
                    "The same radiosities, averaged at the vertices and interpolated over each patch (Gouraud). Edges "
                    "of the room stay "
                    "sharp, since faces do not share vertices.";
                return smooth;
            });
    }

    void idPicture() {
        add({"07_patch_ids.png", "Stage 5: patches drawn as their IDs", "5 renderPatchIDs", "renderPatchIDs", "", {}},
            [this](DemoPicture& picture) {
                blocks.mesh.publish();
                blocks.mesh.reset();
                Hemicube probe(16);
                probe.renderScene(blocks.view.camera.position, blocks.view.camera.up, blocks.view.camera.direction,
                                  renderPatchIDs);
                picture.text = blocks.name() + ", " + blocks.patchCount() +
                               ". Each patch is drawn in the colour that is its number, so that a "
                               "pixel tells which patch it shows; here neighbouring numbers have colours that the eye "
                               "can tell apart.";
                return drawColors(blocks.view, [](std::size_t i) { return idColor(i + 1); });
            });
    }

    void hemicubePicture() {
        add({"08_hemicube.png", "Stage 6: what a patch of the light sees", "6 hemicube, unfolded", "calcFF", "", {}},
            [this](DemoPicture& picture) {
                blocks.mesh.publish();
                blocks.mesh.reset();
                Hemicube hemicube(pictureSize / 2);
                calcFF(&hemicube);
                picture.text =
                    "The hemicube over a patch of the light, its five faces unfolded: the square in the middle looks "
                    "straight down, at the "
                    "two blocks, the four half faces look at the walls, and black is the open front. Adding up the "
                    "delta form factor of every "
                    "pixel that shows a patch gives the patch's form factor, and what is hidden gets none.";
                return hemicubeIds(hemicube);
            });
    }

    void hemicubeFormFactors() {
        add({"09_hemicube_form_factors.png", "Stage 6: form factors with occlusion", "6 calcFF", "calcFF", "", {}},
            [this](DemoPicture& picture) {
                blocks.mesh.publish();
                blocks.mesh.reset();
                Hemicube hemicube(blocks.resource.hemicubeSize);
                const MyPolygon* shooter = calcFF(&hemicube);
                picture.text =
                    "Form factors from one patch of the light, by hemicube, on the same scale as in stage 2. Behind "
                    "the "
                    "blocks they are 0: shadows. They sum to " +
                    decimal(sumOfFormFactors(), 3) + ".";
                return formFactorPicture(blocks, shooter);
            });
    }

    void shadows() {
        add({"10_shadows.png",
             "All stages: shadows and colour bleeding",
             "6 converged, with shadows",
             "calcFF",
             "",
             {}},
            [this](DemoPicture& picture) {
                std::vector<std::pair<Progress, Image>> taken;
                const Progress progress = solve(blocks, "hemicube", [&](const Progress& now) {
                    if (isSnapshot(now.shots)) taken.emplace_back(now, radianceNow());
                });
                taken.emplace_back(progress, radianceNow());
                const float exposure = autoExposure(taken.back().second);
                for (const auto& [at, radiance] : taken) addShot(at, toneMap(radiance, exposure));
                makeStrip();
                picture.text = "The furnished box after " + withCommas(progress.shots) + " shots in " +
                               durationText(progress.seconds) + ", " + percent(progress.unshotShare) +
                               " unshot: soft shadows beside the blocks, red and green light on "
                               "their sides, and a ceiling that is lit by the floor alone.";
                return demo.shots.back().image;
            });
    }

    // 1, 2, 5, 10, 20, 50, 100, …
    static bool isSnapshot(int shots) {
        while (shots % 10 == 0) shots /= 10;
        return shots == 1 || shots == 2 || shots == 5;
    }

    Image radianceNow() const {
        colorReconstruction();
        return drawRadiance(blocks.view, Shading::smooth);
    }

    void addShot(const Progress& at, Image image) {
        char name[32];
        std::snprintf(name, sizeof name, "shots_%05d.png", at.shots);
        demo.shots.push_back({at.shots, at.unshotShare, name, std::move(image)});
    }

    // 1, 10, 100, … and the last, side by side.
    void makeStrip() {
        std::vector<Image> pictures;
        std::vector<std::string> titles;
        for (const DemoShot& shot : demo.shots) {
            const bool power = std::pow(10.0, std::round(std::log10(shot.shots))) == shot.shots;
            if (!power && &shot != &demo.shots.back()) continue;
            pictures.push_back(shot.image.shrunk(2));
            titles.push_back(withCommas(shot.shots) + (shot.shots == 1 ? " shot" : " shots"));
        }
        demo.strip = contactSheet(pictures, titles, std::max<int>(stripShots, static_cast<int>(pictures.size())));
    }

    Progress solve(Setting& setting, const std::string& name, const std::function<void(const Progress&)>& each) {
        Progressive solver = shotsOf(setting);
        // Unshot power falls about exponentially, so its logarithm tells how far the work is.
        ProgressBar bar(name, std::log(1.0 / convergedShare), "");
        Limits limits;
        limits.unshotShare = convergedShare;
        limits.shots = mostShots;
        return solver.run(limits, [&](const Progress& now) {
            if (each) each(now);
            bar.show(std::log(1.0 / std::max(now.unshotShare, 1e-9)),
                     std::to_string(now.shots) + " shots, " + percent(now.unshotShare) + " unshot");
            return true;
        });
    }

    Setting plain, blocks;
    std::function<void(const DemoPicture&)> report;
    Demo demo;
};

}  // namespace

Demo makeDemo(const std::filesystem::path& empty, const std::filesystem::path& furnished,
              const std::function<void(const DemoPicture&)>& report) {
    return DemoMaker(empty, furnished, report).make();
}

}  // namespace radlab
