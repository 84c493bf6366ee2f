// Step by step renders of what each stage of the exercise adds.

#include <iostream>

#include "apps/CommandLine.h"
#include "apps/DemoPage.h"
#include "base/Interrupts.h"
#include "gl/Context.h"

namespace {

void tell(const radlab::DemoPicture& picture) {
    static constexpr const char* outcomes[] = {"made     ", "not yet  ", "failed   "};
    std::cout << outcomes[static_cast<int>(picture.outcome)] << picture.words.title
              << (picture.problem.empty() ? "" : ": ") << picture.problem << std::endl;
}

// Where to go on: the first stage that could not be made, or the page.
void tellNextStep(const radlab::Demo& demo, const std::string& page) {
    std::cout << "open " << page << '\n';
    for (const radlab::DemoPicture& picture : demo.pictures) {
        if (picture.problem.empty()) continue;
        std::cout << "next: " << picture.problem << "; see exercises/ProgRef.cpp\n";
        return;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App flags("Runs the six functions stage by stage and writes pictures and a page that shows them.");
    std::string out = "out/demo";
    std::string empty = RADLAB_SOURCE_DIR "/resources/demo/empty.xml";
    std::string furnished = RADLAB_SOURCE_DIR "/resources/demo/furnished.xml";
    flags.add_option("--out", out, "Folder to write to, made where it does not exist")->capture_default_str();
    flags.add_option("--empty", empty,
                     "Settings (Resource.xml) of stages 1 to 4: a scene in which nothing hides anything");
    flags.add_option("--furnished", furnished, "Settings (Resource.xml) of stages 5 and 6: a scene with shadows");
    flags.footer(
        "Example: ./radlab demo --out /tmp/demo\n         ./radlab demo --exercise   (first: your own functions)");
    return radlab::runCommandLine(flags, argc, argv, [&] {
        const radlab::Interrupts interrupts;
        const auto context = radlab::GlContext::offscreen();
        const radlab::Demo demo = radlab::makeDemo(empty, furnished, tell);
        if (demo.pictures.empty()) radlab::Interrupts::check();
        tellNextStep(demo, radlab::writeDemo(demo, out).string());
        if (!radlab::Interrupts::caught()) return 0;
        std::cout << "stopped by Ctrl-C: the page shows the " << demo.pictures.size() << " pictures made so far\n";
        return 130;
    });
}
