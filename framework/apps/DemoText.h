#pragma once

namespace radlab {

/// The words of one picture of the demo. {{…}} in the text is filled in with the run's figures.
struct DemoText {
    const char* file;
    const char* title;     ///< for the page
    const char* caption;   ///< short, ASCII, for the contact sheet
    const char* function;  ///< the course's function that it shows, or empty
    const char* text;
};

namespace demo {

constexpr DemoText patches = {
    "01_patches.png", "The scene is cut into patches", "patches", "",
    R"({{scene}} is cut into {{patches}} patches. Each is taken to have one radiosity all over. Patches of one face
share their vertices, so colours can be smoothed over a face, but never across an edge of the room.)"};

constexpr DemoText brightest = {
    "02_brightest.png", "Stage 1: the patch with the most unshot power", "1 maxenergy_patch", "maxenergy_patch",
    R"(Unshot power, from black to pale yellow, after {{shots}} shots. The patch with the most, in green, shoots
next: this order makes the picture good early.)"};

constexpr DemoText analyticFormFactors = {
    "03_analytic_form_factors.png", "Stage 2: form factors by formula", "2 calcAnalyticalFF", "calcAnalyticalFF",
    R"(Form factors from one patch of the light, in green, to every other patch, on a logarithmic scale. They sum
to {{sum}}; in a room with an open front, what is missing to 1 leaves through it. The formula sees nothing that
stands in between.)"};

constexpr DemoText firstShots = {
    "04_first_shots.png", "Stage 3: the first shots", "3 distributeEnergy, first shots", "distributeEnergy",
    R"(After {{shots}} shots all patches of the light have shot once: this is direct light. The ceiling is black,
since nothing has reached it yet.)"};

constexpr DemoText flat = {
    "05_flat.png", "Stages 3 and 4: converged, flat", "3 + 4 converged, flat", "colorReconstruction",
    R"(After {{shots}} shots in {{seconds}}, {{unshot}} of the light's power is still unshot. Light that bounced
off the red and green walls colours the floor, the ceiling and the back wall near them. Every patch has its
radiance, rad/π.)"};

constexpr DemoText smooth = {
    "06_smooth.png", "Stage 4: the same, smooth", "4 colorReconstruction, smooth", "colorReconstruction",
    R"(The same radiosities, averaged at the vertices and interpolated over each patch (Gouraud). Edges of the
room stay sharp, since its walls do not share vertices.)"};

constexpr DemoText patchIds = {
    "07_patch_ids.png", "Stage 5: patches drawn as their IDs", "5 renderPatchIDs", "renderPatchIDs",
    R"({{scene}}, {{patches}} patches, each drawn in the colour that is its number, so that a pixel tells which
patch it shows. Here every number that came back has a colour that the eye can tell from the next.)"};

constexpr DemoText hemicube = {
    "08_hemicube.png", "Stage 6: what a patch of the light sees", "6 hemicube, unfolded", "calcFF",
    R"(The hemicube over a patch of the light, its five faces unfolded: the square in the middle looks straight
down, at the two blocks, the four half faces look at the walls, and black is the open front. Adding up the delta form
factor of every pixel that shows a patch gives the patch's form factor, and what is hidden gets none.)"};

constexpr DemoText hemicubeFormFactors = {
    "09_hemicube_form_factors.png", "Stage 6: form factors with occlusion", "6 calcFF", "calcFF",
    R"(Form factors from one patch of the light, by hemicube, on the same scale as in stage 2. Behind the blocks
they are 0: shadows. They sum to {{sum}}.)"};

constexpr DemoText shadows = {
    "10_shadows.png", "All stages: shadows and colour bleeding", "6 converged, with shadows", "calcFF",
    R"({{scene}} after {{shots}} shots in {{seconds}}, {{unshot}} unshot: soft shadows beside the blocks, red and
green light on their sides, and a ceiling that is lit by what the room reflects alone.)"};

}  // namespace demo
}  // namespace radlab
