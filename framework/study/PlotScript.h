#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/Plot.h"

namespace radlab::study {

/// The two forms of every plot: for a desk and for a telephone.
std::string wideFile(const Plot& plot);
std::string narrowFile(const Plot& plot);

/// The script by which gnuplot draws plots as SVG, in both forms.
///
/// Names stand beside the curves, on the right, moved apart where they would overlap.
///
/// @param ending  added to the files' names
std::string plotScript(const std::vector<Plot>& plots, const std::string& ending = "");

/// Draws plots into a folder: the script plots.gp, and what it makes.
///
/// @return false where there is no gnuplot
/// Errors: a gnuplot that fails; a folder that cannot be written.
bool drawPlots(const std::filesystem::path& folder, const std::vector<Plot>& plots);

}  // namespace radlab::study
