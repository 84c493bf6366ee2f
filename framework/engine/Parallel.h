#pragma once

#include <cstddef>
#include <functional>

namespace radlab::engine {

/// Told how many steps are done, now and then, by one thread at a time.
using Progress = std::function<void(std::size_t done)>;

/// Does count steps on all cores; what a step writes is its own business, and no other's.
void forAll(std::size_t count, const Progress& progress, const std::function<void(std::size_t step)>& work);

/// Visits the pixels of a picture on all cores, tile by tile; what a pixel writes is its own business, and no other's.
///
/// Progress counts tiles.
void forAllPixels(int width, int height, const Progress& progress, const std::function<void(int x, int y)>& work);

/// How many tiles forAllPixels goes through.
std::size_t tilesOf(int width, int height);

}  // namespace radlab::engine
