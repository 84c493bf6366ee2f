#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "apps/DemoText.h"
#include "base/Image.h"

namespace radlab {

/// A picture of the demo and what it shows.
struct DemoPicture {
    enum class Outcome { made, notWritten, failed };

    DemoText words;
    std::map<std::string, std::string> figures;  ///< what fills in the text's {{…}}
    Image image;
    Outcome outcome = Outcome::made;
    std::string problem;  ///< what went wrong, where it was not made
};

/// A picture of the solution after some shots.
struct DemoShot {
    int shots = 0;
    std::string unshot;  ///< share of the emitted power, "3.8 %"
    std::string file;
    Image image;
};

/// What the demo has made.
struct Demo {
    std::vector<DemoPicture> pictures;
    std::vector<DemoShot> shots;
    Image strip;
    double seconds = 0.0;
};

/// Runs the six functions, stage by stage, on the empty and the furnished scene.
///
/// A stub, or a function that leaves something impossible behind, ends its stage with a picture that says so; the others go on.
/// Once Interrupts has caught something, the picture at hand shows the shots made so far, and no other is begun.
///
/// @param empty, furnished settings files (Resource.xml)
/// @param report called with each picture when it is ready
/// @pre   a GlContext is current
/// Errors: those of the readers and the Mesher.
Demo makeDemo(const std::filesystem::path& empty, const std::filesystem::path& furnished,
              const std::function<void(const DemoPicture&)>& report);

}  // namespace radlab
