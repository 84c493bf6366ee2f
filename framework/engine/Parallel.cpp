#include "engine/Parallel.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"

namespace radlab::engine {

namespace {

constexpr int tileSize = 16;

int tilesAlong(int pixels) { return (pixels + tileSize - 1) / tileSize; }

}  // namespace

void forAll(std::size_t count, const Progress& progress, const std::function<void(std::size_t step)>& work) {
    std::atomic<std::size_t> done{0};
    std::mutex telling;
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t step) {
        Interrupts::check();
        work(step);
        const std::size_t now = ++done;
        if (!progress) return;
        const std::unique_lock lock(telling, std::try_to_lock);
        if (lock) progress(now);
    });
}

void forAllPixels(int width, int height, const Progress& progress, const std::function<void(int x, int y)>& work) {
    forAll(tilesOf(width, height), progress, [&](std::size_t tile) {
        const int columns = tilesAlong(width), index = static_cast<int>(tile);
        const int left = index % columns * tileSize, top = index / columns * tileSize;
        for (int y = top; y < std::min(height, top + tileSize); ++y)
            for (int x = left; x < std::min(width, left + tileSize); ++x) work(x, y);
    });
}

std::size_t tilesOf(int width, int height) {
    return static_cast<std::size_t>(tilesAlong(width)) * static_cast<std::size_t>(tilesAlong(height));
}

}  // namespace radlab::engine
