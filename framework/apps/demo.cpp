// Step by step renders of what each stage of the exercise adds.

#include <iostream>

#include <CLI/CLI.hpp>

#include "apps/DemoPage.h"
#include "base/Program.h"
#include "gl/Context.h"

int main(int argc, char** argv) {
    CLI::App flags("Runs the six functions stage by stage and writes pictures and a page that shows them.");
    std::string out = "out/demo";
    std::string empty = RADLAB_SOURCE_DIR "/resources/demo/empty.xml";
    std::string furnished = RADLAB_SOURCE_DIR "/resources/demo/furnished.xml";
    flags.add_option("--out", out, "Folder to write to, made where it does not exist")->capture_default_str();
    flags.add_option("--empty", empty,
                     "Settings (Resource.xml) of stages 1 to 4: a scene in which nothing hides anything");
    flags.add_option("--furnished", furnished, "Settings (Resource.xml) of stages 5 and 6: a scene with shadows");
    flags.set_version_flag("--version", "radlab " RADLAB_VERSION);
    flags.footer(
        "Example: ./radlab demo --out /tmp/demo\n         ./radlab demo --exercise   (first: your own functions)");
    try {
        flags.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return flags.exit(error) == 0 ? 0 : 2;
    }
    return radlab::runProgram([&] {
        const auto context = radlab::GlContext::offscreen();
        const radlab::Demo demo = radlab::makeDemo(empty, furnished, [](const radlab::DemoPicture& picture) {
            std::cout << (picture.written ? "made     " : "not yet  ") << picture.title << std::endl;
        });
        std::cout << "open " << radlab::writeDemo(demo, out).string() << '\n';
        return 0;
    });
}
