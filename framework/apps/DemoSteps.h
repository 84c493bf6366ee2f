#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/Image.h"

namespace radlab {

/// A picture of the demo and what it shows.
struct DemoPicture {
    std::string file;      ///< name inside the demo's folder
    std::string title;     ///< for the page
    std::string caption;   ///< short, ASCII, for the contact sheet
    std::string function;  ///< the course's function that it shows, or empty
    std::string text;      ///< one paragraph, filled in with the run's figures
    Image image;
    bool written = true;  ///< false where the function is a stub
};

/// A picture of the solution after some shots.
struct DemoShot {
    int shots = 0;
    double unshotShare = 0.0;
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
/// A stub ends its stage with a picture that says so; the others go on.
///
/// @param empty, furnished settings files (Resource.xml)
/// @param report called with each picture when it is ready
/// @pre   a GlContext is current
/// Errors: those of the readers and the Mesher.
Demo makeDemo(const std::filesystem::path& empty, const std::filesystem::path& furnished,
              const std::function<void(const DemoPicture&)>& report);

}  // namespace radlab
