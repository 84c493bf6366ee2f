#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/stages/HemicubeFFWays.h"

namespace radlab::grader {

namespace {

// Which pixels count ----------------------------------------------------------------------------

std::vector<Mistake> parts(const Ways& ways) {
    const std::string edge = "The buffer has rendersize pixels each way: it holds the top face and the four sides.";
    const std::string rim =
        "A row and a column of pixels are left out at the rim of the buffer: pixels go from 0 to rendersize - 1.";
    const std::string rimHint = "Which are the first and the last value of your loops?";
    return {
        {"quarter-of-the-buffer", "Only a quarter of the buffer is looked at. " + edge, "How far do your two loops go?",
         ways.part([](int x, int y, int n) { return x < n / 2 && y < n / 2; })},
        {"half-of-the-buffer", "Only the lower half of the buffer is looked at. " + edge,
         "How far do your two loops go?", ways.part([](int, int y, int n) { return y < n / 2; })},
        {"half-of-the-buffer", "Only the left half of the buffer is looked at. " + edge,
         "How far do your two loops go?", ways.part([](int x, int, int n) { return x < n / 2; })},
        {"top-face-only", "Only the top face is looked at. What arrives through the four sides is missing. " + edge,
         "How many faces has half a cube?",
         ways.part([](int x, int y, int n) { return x >= n / 4 && x < 3 * n / 4 && y >= n / 4 && y < 3 * n / 4; })},
        {"diagonal-only", "Only the pixels with x = y are looked at: one loop for both. " + edge,
         "How many pixels are there, and how often does your loop run?",
         ways.part([](int x, int y, int) { return x == y; })},
        {"rim-left-out", rim, rimHint, ways.part([](int x, int y, int) { return x > 0 && y > 0; })},
        {"rim-left-out", rim, rimHint, ways.part([](int x, int y, int n) { return x < n - 1 && y < n - 1; })},
        {"rim-left-out", rim, rimHint,
         ways.part([](int x, int y, int n) { return x > 0 && y > 0 && x < n - 1 && y < n - 1; })},
    };
}

// Whose pixels they are -------------------------------------------------------------------------

std::vector<Mistake> indices(const Ways& ways) {
    const std::string id = "The ID of polygons[i] is i + 1, since 0 is the background.";
    return {
        {"index-one-byte", "The index goes through a number of 8 bits: patches after the 255th are taken for others.",
         "What does getIndex return, and where do you keep it?", ways.narrow<std::uint8_t>()},
        {"index-one-byte",
         "The index goes through a number of 8 bits with a sign: patches after the 127th are lost or taken for others.",
         "What does getIndex return, and where do you keep it?", ways.narrow<std::int8_t>()},
        {"index-16-bit", "The index goes through a number of 16 bits: patches after the 65,535th are taken for others.",
         "What does getIndex return, and where do you keep it?", ways.narrow<std::uint16_t>()},
        {"index-16-bit",
         "The index goes through a number of 16 bits with a sign: patches after the 32,767th are lost or taken for "
         "others.",
         "What does getIndex return, and where do you keep it?", ways.narrow<std::int16_t>()},
        {"id-off-by-one", "What a patch shows goes to the next one: the ID is used as the index. " + id,
         "Which patch has the ID 1?",
         ways.target([](int patch, int count) { return patch >= 0 && patch + 1 < count ? patch + 1 : -1; })},
        {"id-off-by-one",
         "What a patch shows goes to the next one, and the background to the first: the ID is used as the index. " + id,
         "Which patch has the ID 1?",
         ways.target([](int patch, int count) { return patch + 1 < count ? patch + 1 : -1; })},
        {"id-off-by-one", "What a patch shows goes to the one before it. " + id, "Which patch has the ID 1?",
         ways.target([](int patch, int) { return std::max(patch - 1, -1); })},
        {"first-patch-lost", "polygons[0] gets nothing: its ID is taken for the background. " + id,
         "Which ID is no patch's?", ways.target([](int patch, int) { return patch == 0 ? -1 : patch; })},
        {"last-patch-lost", "The last patch gets nothing: its ID is as large as the number of patches. " + id,
         "Which is the largest ID that there is?",
         ways.target([](int patch, int count) { return patch == count - 1 ? -1 : patch; })},
        {"background-counted", "The background is added to the first patch. " + id,
         "What should happen where the hemicube sees nothing?",
         ways.target([](int patch, int) { return std::max(patch, 0); })},
        {"background-counted", "The background is added to the last patch. " + id,
         "What should happen where the hemicube sees nothing?",
         ways.target([](int patch, int count) { return patch < 0 ? count - 1 : patch; })},
    };
}

// What a pixel gives ----------------------------------------------------------------------------

// Many equal numbers, added up in floats, all round the same way.
void allowEqualRounding(Shot& shot) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) shot.row.slack[j] += 2e-4 * shot.row.values[j];
}

// Each pixel counts 1, or 1 over a share of all pixels.
Computation counted(const Ways& ways, float share) {
    return ways.with([share](ShotWay& way) {
        way.weight = [share](int, int, int edge, float) {
            return share == 0.0f ? 1.0f : 1.0f / (share * static_cast<float>(edge) * static_cast<float>(edge));
        };
        way.finish = allowEqualRounding;
    });
}

std::vector<Mistake> weights(const Ways& ways) {
    const std::string pixels =
        "A pixel at the rim of the hemicube carries less power than one at its top: that is what "
        "getDeltaFormFactor says.";
    const std::string alike = "Pixels are counted, and their number is divided by that of all pixels. " + pixels;
    return {
        {"pixels-counted", "Pixels are counted. " + pixels, "What is the form factor of a single pixel?",
         counted(ways, 0.0f)},
        {"pixels-counted", alike, "What is the form factor of a single pixel?", counted(ways, 1.0f)},
        {"pixels-counted", alike, "What is the form factor of a single pixel?", counted(ways, 0.75f)},
        {"pixels-counted", alike, "What is the form factor of a single pixel?", counted(ways, 0.25f)},
        {"delta-squared", "The delta form factor of each pixel is multiplied by itself.",
         "What is added for one pixel?", ways.weight([](int, int, int, float delta) { return delta * delta; })},
    };
}

// The delta form factor of the pixel that comes last, row by row or column by column.
Row lastPixel(const Shot& shot, bool byColumn) {
    Row row = nothing(shot);
    const IdImage& image = shot.buffer.image;
    const auto edge = static_cast<std::size_t>(image.width);
    for (std::size_t k = 0; k < image.patch.size(); ++k) {
        const std::size_t pixel = byColumn ? k % edge * edge + k / edge : k;
        if (image.sure[pixel] && image.patch[pixel] >= 0) {
            const auto j = static_cast<std::size_t>(image.patch[pixel]);
            row.values[j] = static_cast<double>(shot.weights[pixel]);
            row.slack[j] = 0.0;
        }
        for (const int patch : image.candidatesOf(pixel))
            if (patch >= 0) row.slack[static_cast<std::size_t>(patch)] = unknown;
    }
    return row;
}

// The largest delta form factor.
Row largestPixel(const Shot& shot) {
    Row row = nothing(shot);
    const IdImage& image = shot.buffer.image;
    std::vector<double> most(row.values.size());
    for (std::size_t pixel = 0; pixel < image.patch.size(); ++pixel) {
        const auto delta = static_cast<double>(shot.weights[pixel]);
        if (image.sure[pixel] && image.patch[pixel] >= 0) {
            double& value = row.values[static_cast<std::size_t>(image.patch[pixel])];
            value = std::max(value, delta);
        }
        for (const int patch : image.candidatesOf(pixel))
            if (patch >= 0)
                most[static_cast<std::size_t>(patch)] = std::max(most[static_cast<std::size_t>(patch)], delta);
    }
    for (std::size_t j = 0; j < most.size(); ++j) row.slack[j] = std::max(most[j] - row.values[j], 0.0);
    return row;
}

// Each of the many sums rounds by what is already there.
void addStale(Shot& shot) {
    for (std::size_t j = 0; j < shot.row.values.size(); ++j) {
        shot.row.values[j] += shot.stale.values[j];
        shot.row.slack[j] += shot.stale.slack[j] + 1e-5 * shot.stale.values[j];
    }
}

std::vector<Mistake> sums(const Ways& ways) {
    const std::string add = "A patch covers many pixels, and its form factor is the sum of theirs.";
    const auto collected = [&](const std::function<Row(const Shot&)>& collect) {
        return ways.with([&](ShotWay& way) { way.collect = collect; });
    };
    return {
        {"assigned", "formF is overwritten at each pixel, not added to: what is left is that of the last one. " + add,
         "What happens to formF at the second pixel that shows the same patch?",
         collected([](const Shot& shot) { return lastPixel(shot, false); })},
        {"assigned", "formF is overwritten at each pixel, not added to: what is left is that of the last one. " + add,
         "What happens to formF at the second pixel that shows the same patch?",
         collected([](const Shot& shot) { return lastPixel(shot, true); })},
        {"largest-pixel", "formF is that of the patch's largest pixel. " + add, "What do several pixels give together?",
         collected(largestPixel)},
        {"stale-form-factors", "What an earlier shot left in formF is still there, and this shot's is added to it.",
         "What is formF of every patch before you add the first pixel?", ways.finish(addStale)},
    };
}

}  // namespace

std::vector<Mistake> pixelMistakes(const Ways& ways) {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {indices(ways), parts(ways), weights(ways), sums(ways)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader
