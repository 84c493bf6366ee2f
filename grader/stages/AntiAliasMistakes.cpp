#include "grader/stages/AntiAliasMistakes.h"

#include <glm/glm.hpp>

namespace radlab::grader {

namespace {

// Where sample i of so many lies along one side of a pixel, 0 to 1.
using Place = std::function<float(int i, int samples)>;

float atCentre(int i, int samples) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(samples); }

// Goes through samples x samples places, and adds up what `take` makes of the radiance there.
Vec3f total(const PictureView& view, float x, float y, int samples, const Place& place,
            const std::function<Vec3f(const Vec3f&)>& take) {
    Vec3f sum(0.0f);
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) sum += take(view.radiance(x + place(i, samples), y + place(j, samples)));
    return sum;
}

Vec3f asItIs(const Vec3f& radiance) { return radiance; }

Vec3f mean(const PictureView& view, float x, float y, int samples, const Place& place = atCentre) {
    return total(view, x, y, samples, place, asItIs) / static_cast<float>(samples * samples);
}

PixelRule placed(const Place& place) {
    return [place](const PictureView& view, float x, float y, int samples, const Vec3f&) {
        return view.display(mean(view, x, y, samples, place));
    };
}

PixelRule shifted(float by) {
    return placed([by](int i, int samples) { return atCentre(i, samples) + by; });
}

// Of what the mean radiance becomes.
PixelRule shown(const std::function<Vec3f(const PictureView& view, const Vec3f& mean, int samples)>& made) {
    return [made](const PictureView& view, float x, float y, int samples, const Vec3f&) {
        return made(view, mean(view, x, y, samples), samples);
    };
}

// Samples along one line of the pixel.
PixelRule along(bool x, bool y) {
    return [x, y](const PictureView& view, float left, float top, int samples, const Vec3f&) {
        Vec3f sum(0.0f);
        for (int i = 0; i < samples; ++i)
            sum += view.radiance(left + (x ? atCentre(i, samples) : 0.5f), top + (y ? atCentre(i, samples) : 0.5f));
        return view.display(sum / static_cast<float>(samples));
    };
}

std::vector<PixelMistake> orders() {
    return {
        {"averages-display-values",
         "Display values are averaged, not radiance. The tone curve is not linear, so half light and half dark comes "
         "out too dark, and a "
         "lamp's edge too.",
         "Which of the two adds up where two lights fall into one pixel: radiance, or what the screen is told?",
         [](const PictureView& view, float x, float y, int samples, const Vec3f&) {
             return total(view, x, y, samples, atCentre, [&](const Vec3f& r) { return view.display(r); }) /
                    static_cast<float>(samples * samples);
         }},
        {"clamped-first",
         "Each sample is cut off at white before the mean is taken. A lamp that covers a tenth of a pixel, and is "
         "twenty times as bright as "
         "white, still makes it white.",
         "Radiance has no upper end. Where is the one place to cut it off?",
         [](const PictureView& view, float x, float y, int samples, const Vec3f&) {
             const auto cut = [](const Vec3f& r) { return glm::min(r, Vec3f(1.0f)); };
             return view.display(total(view, x, y, samples, atCentre, cut) / static_cast<float>(samples * samples));
         }},
        {"no-tone-curve", "The mean radiance is not made ready for display.",
         "Which function of the view turns radiance into what a screen shows?",
         shown([](const PictureView&, const Vec3f& m, int) { return m; })},
        {"tone-curve-twice", "The tone curve is applied twice, so that the picture is too bright and flat.",
         "How often does view.display see each value?",
         shown([](const PictureView& view, const Vec3f& m, int) { return view.display(view.display(m)); })},
    };
}

std::vector<PixelMistake> sums() {
    const auto times = [](const std::function<double(int)>& factor) {
        return shown([factor](const PictureView& view, const Vec3f& m, int n) { return view.display(m * factor(n)); });
    };
    return {
        {"not-divided",
         "The samples are added up, but the sum is not divided by their number: with more samples, it gets brighter.",
         "What is the mean of four samples that are all the same?", times([](int n) { return double(n) * n; })},
        {"divided-by-one-side", "The sum is divided by the samples along one side of the pixel, not by all in it.",
         "How many samples does a pixel have, if there are three along each side?",
         times([](int n) { return double(n); })},
        {"divided-too-often", "The sum is divided by the number of samples twice.",
         "What is the mean of four samples that are all the same?", times([](int n) { return 1.0 / (double(n) * n); })},
        {"added-to-old", "The value is added to what the picture held before.",
         "Whatever the picture holds when your function is called should not matter.",
         [](const PictureView& view, float x, float y, int samples, const Vec3f& held) {
             return held + view.display(mean(view, x, y, samples));
         }},
        {"first-sample-kept", "The sum starts from what the picture held before.",
         "What is the sum before the first sample?",
         [](const PictureView& view, float x, float y, int samples, const Vec3f& held) {
             return view.display(mean(view, x, y, samples) + held / static_cast<float>(samples * samples));
         }},
    };
}

std::vector<PixelMistake> places() {
    const std::string count = "With samples = 2, at which four points of the pixel should you look?";
    return {
        {"one-sample", "Each pixel gets one sample, at its centre, however many are asked for.", count,
         placed([](int, int) { return 0.5f; })},
        {"one-corner",
         "All samples of a pixel lie at its corner. A division of whole numbers, i / samples, is always 0.", count,
         placed([](int, int) { return 0.0f; })},
        {"along-a-line", "The samples lie along one row of the pixel, so that only edges across that are smoothed.",
         count, along(true, false)},
        {"along-a-line", "The samples lie along one column of the pixel, so that only edges across that are smoothed.",
         count, along(false, true)},
        {"along-a-line", "The samples lie along the pixel's diagonal, which leaves most of it unseen.", count,
         along(true, true)},
        {"corners-of-squares",
         "The samples lie at the corners of the small squares, not at their centres: the whole picture moves by half a "
         "square to one side.",
         "Is the mean of all your sample points the pixel's centre?",
         placed([](int i, int n) { return static_cast<float>(i) / static_cast<float>(n); })},
        {"corners-of-squares",
         "The samples lie at the far corners of the small squares, not at their centres: the whole picture moves by "
         "half a square.",
         "Is the mean of all your sample points the pixel's centre?",
         placed([](int i, int n) { return static_cast<float>(i + 1) / static_cast<float>(n); })},
        {"ends-included",
         "The samples reach from one side of the pixel to the other, so that those at the rim belong to two pixels, "
         "and one alone has no place.",
         "Cut the pixel into equal squares: how far is the first centre from the side?",
         placed([](int i, int n) { return static_cast<float>(i) / static_cast<float>(n - 1); })},
        {"ends-included",
         "The samples reach from one side of the pixel to the other, so that those at the rim belong to two pixels.",
         "Cut the pixel into equal squares: how far is the first centre from the side?",
         placed([](int i, int n) { return n == 1 ? 0.5f : static_cast<float>(i) / static_cast<float>(n - 1); })},
        {"half-pixel-off",
         "The samples are spread round the pixel's top left corner, not over the pixel: the picture moves by half a "
         "pixel.",
         "Where is the centre of pixel (0, 0)?", shifted(-0.5f)},
        {"half-pixel-off",
         "The pixel's centre is added to samples that are spread over the pixel already: the picture moves by half a "
         "pixel.",
         "Where is the centre of pixel (0, 0)?", shifted(0.5f)},
        {"steps-of-a-pixel",
         "The samples are whole pixels apart, so that the mean is over neighbouring pixels: a blur, not the pixel's "
         "own light.",
         "How far apart are samples, if there are three along each side of a pixel?",
         placed([](int i, int) { return static_cast<float>(i) + 0.5f; })},
        {"steps-of-a-pixel",
         "The samples are whole pixels apart, so that the mean is over neighbouring pixels: a blur, not the pixel's "
         "own light.",
         "How far apart are samples, if there are three along each side of a pixel?",
         placed([](int i, int) { return static_cast<float>(i); })},
        {"upside-down", "The picture stands on its head: its row 0 is at the top.",
         "Which way does y run in the view, and in the picture?", antialiasedPixel, true},
    };
}

}  // namespace

Vec3f antialiasedPixel(const PictureView& view, float x, float y, int samples, const Vec3f&) {
    return view.display(mean(view, x, y, samples));
}

std::vector<PixelMistake> samplingMistakes() {
    std::vector<PixelMistake> all;
    for (const std::vector<PixelMistake>& some : {orders(), sums(), places()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader
