// What the handout shows, made from the scenes: numbers, tables for plots, pictures.

#include <cmath>
#include <iostream>

#include <glm/common.hpp>

#include "apps/CommandLine.h"
#include "apps/HandoutCurves.h"
#include "apps/HandoutNumbers.h"
#include "apps/HandoutPictures.h"
#include "base/Error.h"
#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "display/ToneMap.h"
#include "gl/Context.h"

namespace {

using namespace radlab;

struct Flags {
    std::string out, picture, reference;
    float exposure = 1.0f;
    int shrink = 1;
};

// Radiance up to what is shown as white: a lamp that is twenty times as bright as all else would decide every error.
Image shown(Image radiance, float exposure) {
    for (glm::vec3& pixel : radiance.data()) pixel = glm::min(pixel, glm::vec3(1.0f / exposure));
    return radiance;
}

int numbers(const Flags& flags) {
    const auto context = GlContext::offscreen();
    writeFile(flags.out, handoutNumbers().dump(1) + "\n");
    return 0;
}

int curves(const Flags& flags) {
    makeFolder(flags.out);
    const auto found = writeHandoutCurves(flags.out);
    writeFile(std::filesystem::path(flags.out) / "curves.json", found.dump(1) + "\n");
    return 0;
}

int pictures(const Flags& flags) {
    const auto context = GlContext::offscreen();
    makeFolder(flags.out);
    drawHandoutPictures(flags.out);
    return 0;
}

int compare(const Flags& flags) {
    const Image reference = shown(readImage(flags.reference), flags.exposure);
    const Image picture = shown(readImage(flags.picture), flags.exposure);
    if (picture.width() != reference.width() || picture.height() != reference.height())
        throw Error(flags.picture + ": found another size than that of " + flags.reference + ", expected the same");
    const Image black(reference.width(), reference.height());
    std::cout << rmsDifference(picture, reference) / rmsDifference(reference, black) << '\n';
    return 0;
}

int display(const Flags& flags) {
    Image picture = readImage(flags.picture);
    if (flags.shrink < 1 || picture.width() % flags.shrink != 0 || picture.height() % flags.shrink != 0)
        throw Error(flags.picture + ": found edges that " + std::to_string(flags.shrink) + " does not divide");
    if (std::filesystem::path(flags.picture).extension() == ".hdr") picture = toneMap(picture, flags.exposure);
    writeImage(flags.out, picture.shrunk(flags.shrink));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Makes what the handout shows; ./radlab handout --figures runs it.");
    Flags flags;
    app.require_subcommand(1);
    std::function<int()> work;
    const auto command = [&](const char* name, const char* what, int (*run)(const Flags&)) {
        CLI::App* added = app.add_subcommand(name, what);
        added->callback([&work, &flags, run] { work = [&flags, run] { return run(flags); }; });
        return added;
    };
    for (CLI::App* made : {command("numbers", "The numbers that no machine changes, as JSON", numbers),
                           command("curves", "Tables for the plots, and numbers from them", curves),
                           command("pictures", "Pictures of single steps", pictures),
                           command("display", "A picture made ready for the page", display)})
        made->add_option("-o,--out", flags.out, "The file or folder to write")->required();
    for (CLI::App* made :
         {command("compare", "The relative error of a picture", compare), app.get_subcommand("display")}) {
        made->add_option("PICTURE", flags.picture, "A picture")->required();
        made->add_option("--exposure", flags.exposure, "Display value per radiance")->check(CLI::PositiveNumber);
    }
    app.get_subcommand("compare")->add_option("--reference", flags.reference, "The truth")->required();
    app.get_subcommand("display")->add_option("--shrink", flags.shrink, "Pixels of an edge that become one");
    return runCommandLine(app, argc, argv, [&] { return work(); });
}
