#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace radlab {

/// Writes what the handout's plots draw, as tables with a space between their columns: point.dat, orders.dat, hemicube.dat, hemisphere.dat.
///
/// @return numbers that the text takes from them
/// @cost   about a minute
nlohmann::ordered_json writeHandoutCurves(const std::filesystem::path& folder);

}  // namespace radlab
