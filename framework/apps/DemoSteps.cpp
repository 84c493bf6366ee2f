#include "apps/DemoSteps.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/NumberText.h"
#include "base/ProgressBar.h"
#include "base/Warning.h"
#include "course/ProgRef.h"
#include "display/Draw.h"
#include "display/FalseColor.h"
#include "display/HemicubePicture.h"
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
const glm::vec3 marked(0.1f, 0.9f, 0.3f);

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

    Resource resource;
    Scene scene;
    PatchMesh mesh;
    View view;
};

// A picture of a word or two in place of one that could not be made.
Image notice(const std::string& first, const std::string& second) {
    Image image(pictureSize, pictureSize, glm::vec3(0.16f, 0.17f, 0.2f));
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
        result.seconds = watch.seconds();
        return std::move(result);
    }

private:
    using Outcome = DemoPicture::Outcome;
    using Figures = std::map<std::string, std::string>;

    // Adds a picture; where a function is a stub or goes wrong, one that says so.
    void add(const DemoText& words, const std::function<Image(Figures&)>& draw) {
        if (Interrupts::caught()) return;
        DemoPicture picture{words, {}, {}, Outcome::made, ""};
        try {
            picture.image = draw(picture.figures);
        } catch (const NotImplemented& stub) {
            picture.image = notice(stub.function(), "is not written yet");
            picture.outcome = Outcome::notWritten;
            picture.problem = stub.what();
        } catch (const Error& error) {
            picture.image = notice("went wrong", "the page says how");
            picture.outcome = Outcome::failed;
            picture.problem = error.what();
        }
        report(picture);
        result.pictures.push_back(std::move(picture));
    }

    // Makes the scene the course's, as it is before the first shot.
    static void begin(Setting& setting) {
        setting.mesh.publish();
        setting.mesh.reset();
    }

    static Progressive shotsOf(Setting& setting) {
        const FormFactorMethod method = formFactorMethod(setting.resource, setting.scene);
        return {setting.mesh, formFactorsBy(method, setting.resource.hemicubeSize)};
    }

    void meshPicture() {
        add(demo::patches, [this](Figures& figures) {
            begin(plain);
            figures = {{"scene", plain.name()}, {"patches", withCommas(plain.mesh.patches.size())}};
            return drawWireframe(plain.view);
        });
    }

    void brightestPicture() {
        add(demo::brightest, [this](Figures& figures) {
            figures["shots"] = std::to_string(shootTheLightIfWritten(plain));
            const MyPolygon* brightest = maxenergy_patch();
            if (!brightest) throw Error("maxenergy_patch: found nullptr, expected a patch");
            const float most = unshotPower(*brightest);
            return drawColors(plain.view, [=](std::size_t i) {
                return polygons[i] == brightest ? marked : heatColor(unshotPower(*polygons[i]) / most);
            });
        });
    }

    // As many shots as the light has patches.
    static int shootTheLight(Setting& setting) {
        Progressive solver = shotsOf(setting);
        const auto lights = std::count_if(polygons.begin(), polygons.end(),
                                          [](const MyPolygon* p) { return p->emissive != Vec3f(0.0f); });
        while (solver.progress().shots < lights && solver.shoot()) {
        }
        return solver.progress().shots;
    }

    // The same, but where later stages are stubs the scene stays as it is before the first shot.
    static int shootTheLightIfWritten(Setting& setting) {
        try {
            return shootTheLight(setting);
        } catch (const NotImplemented&) {
            setting.mesh.reset();
            return 0;
        }
    }

    void analyticFormFactors() {
        add(demo::analyticFormFactors, [this](Figures& figures) {
            begin(plain);
            return formFactorPicture(plain, calcAnalyticalFF(), figures);
        });
    }

    static Image formFactorPicture(const Setting& setting, const MyPolygon* shooter, Figures& figures) {
        double sum = 0.0;
        for (const MyPolygon* patch : polygons) sum += static_cast<double>(patch->formF);
        figures["sum"] = decimal(sum, 3);
        return drawColors(setting.view, [shooter](std::size_t i) {
            return polygons[i] == shooter ? marked : formFactorColor(polygons[i]->formF);
        });
    }

    void firstShots() {
        add(demo::firstShots, [this](Figures& figures) {
            figures["shots"] = std::to_string(shootTheLight(plain));
            colorReconstruction();
            const Image radiance = drawRadiance(plain.view, Shading::flat);
            return toneMap(radiance, autoExposure(radiance));
        });
    }

    void convergedAnalytic() {
        Image flat;  // both pictures are shown with its exposure
        const auto solveOnce = [&](Figures& figures) {
            if (!flat.empty()) return;
            figures = figuresOf(solve(plain, {}));
            flat = drawRadiance(plain.view, Shading::flat);
        };
        add(demo::flat, [&](Figures& figures) {
            solveOnce(figures);
            return toneMap(flat, autoExposure(flat));
        });
        add(demo::smooth, [&](Figures& figures) {
            solveOnce(figures);
            return toneMap(drawRadiance(plain.view, Shading::smooth), autoExposure(flat));
        });
    }

    static Figures figuresOf(const Progress& progress) {
        return {{"shots", withCommas(static_cast<std::size_t>(progress.shots))},
                {"seconds", durationText(progress.seconds)},
                {"unshot", percent(progress.unshotShare)}};
    }

    void idPicture() {
        add(demo::patchIds, [this](Figures& figures) {
            begin(blocks);
            figures = {{"scene", blocks.name()}, {"patches", withCommas(blocks.mesh.patches.size())}};
            return drawIds(blocks.view, renderPatchIDs);
        });
    }

    void hemicubePicture() {
        add(demo::hemicube, [this](Figures&) {
            begin(blocks);
            Hemicube hemicube(pictureSize / 2);
            calcFF(&hemicube);
            return hemicubeIds(hemicube);
        });
    }

    void hemicubeFormFactors() {
        add(demo::hemicubeFormFactors, [this](Figures& figures) {
            begin(blocks);
            Hemicube hemicube(blocks.resource.hemicubeSize);
            return formFactorPicture(blocks, calcFF(&hemicube), figures);
        });
    }

    void shadows() {
        add(demo::shadows, [this](Figures& figures) {
            std::vector<std::pair<Progress, Image>> taken;
            const Progress progress = solve(blocks, [&](const Progress& now) {
                if (isSnapshot(now.shots)) taken.emplace_back(now, radianceNow());
            });
            if (taken.empty() || taken.back().first.shots != progress.shots)
                taken.emplace_back(progress, radianceNow());
            const float exposure = autoExposure(taken.back().second);
            for (const auto& [at, radiance] : taken) addShot(at, toneMap(radiance, exposure));
            makeStrip();
            figures = figuresOf(progress);
            figures["scene"] = blocks.name();
            return result.shots.back().image;
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
        result.shots.push_back({at.shots, percent(at.unshotShare), name, std::move(image)});
    }

    // 1, 10, 100, … and the last, side by side.
    void makeStrip() {
        std::vector<Image> pictures;
        std::vector<std::string> titles;
        for (const DemoShot& shot : result.shots) {
            const bool power = std::pow(10.0, std::round(std::log10(shot.shots))) == shot.shots;
            if (!power && &shot != &result.shots.back()) continue;
            pictures.push_back(shot.image.shrunk(2));
            titles.push_back(withCommas(static_cast<std::size_t>(shot.shots)) + (shot.shots == 1 ? " shot" : " shots"));
        }
        result.strip = contactSheet(pictures, titles, std::max<int>(stripShots, static_cast<int>(pictures.size())));
    }

    // How far the shots are from the wanted share, if unshot power goes on falling as over the last half of them.
    static double doneShare(const std::vector<double>& unshotAfter) {
        const std::size_t shots = unshotAfter.size();
        const double now = unshotAfter.back(), before = unshotAfter[shots / 2];
        const double fallPerShot = std::log(before / now) / static_cast<double>(std::max<std::size_t>(shots / 2, 1));
        if (!(fallPerShot > 0.0)) return 0.0;
        const double left = std::max(std::log(now / convergedShare), 0.0) / fallPerShot;
        return static_cast<double>(shots) / (static_cast<double>(shots) + left);
    }

    static Progress solve(Setting& setting, const std::function<void(const Progress&)>& each) {
        Progressive solver = shotsOf(setting);
        ProgressBar bar(setting.name(), 1.0);
        std::vector<double> unshotAfter = {1.0};
        Limits limits;
        limits.unshotShare = convergedShare;
        limits.shots = mostShots;
        return solver.run(limits, [&](const Progress& now) {
            if (each) each(now);
            unshotAfter.push_back(now.unshotShare);
            bar.show(doneShare(unshotAfter),
                     std::to_string(now.shots) + " shots, " + percent(now.unshotShare) + " unshot");
            return !Interrupts::caught();
        });
    }

    Setting plain, blocks;
    std::function<void(const DemoPicture&)> report;
    Demo result;
};

}  // namespace

Demo makeDemo(const std::filesystem::path& empty, const std::filesystem::path& furnished,
              const std::function<void(const DemoPicture&)>& report) {
    return DemoMaker(empty, furnished, report).make();
}

}  // namespace radlab
