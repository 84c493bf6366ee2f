#pragma once

#include <array>
#include <string>

#include "display/ToneMap.h"
#include "scene/ResourceFile.h"
#include "viewer/OrbitCamera.h"

namespace radlab {

/// What is shown of the patches.
enum class Mode {
    wireframe,    ///< reflectances and the mesh
    flat,         ///< radiance, one colour a patch
    smooth,       ///< radiance, from corner to corner
    unshot,       ///< unshot power as false colour
    ids,          ///< what renderPatchIDs draws
    formFactors,  ///< from the picked patch, or the last shooter, as a heat map
};

constexpr std::array<Mode, 6> allModes{Mode::wireframe, Mode::flat, Mode::smooth,
                                       Mode::unshot,    Mode::ids,  Mode::formFactors};

/// The mode's name as the user reads it, and as files keep it.
const char* nameOf(Mode mode);
const char* nameOf(ToneCurve curve);
const char* nameOf(FormFactorMethod method);

/// All that a user sets for a scene. Plain data, so that it can lie in memory that processes share.
struct ViewState {
    float patchSize = 0.0f, lightSize = 0.0f;  ///< longest edge, in the scene's unit; 0: not chosen yet
    int hemicubeSize = 256;                    ///< pixels along an edge, even
    FormFactorMethod method = FormFactorMethod::automatic;
    Mode mode = Mode::smooth;
    bool meshLines = false;
    bool autoExposure = true;
    float exposure = 1.0f;  ///< display value per radiance
    ToneCurve curve = ToneCurve::clamp;
    int shotsPerFrame = 0;  ///< 0: as many as fit into a frame
    bool panel = true;
    OrbitCamera camera;
};

/// The state as JSON, which fromJson reads back to the last bit.
std::string toJson(const ViewState& state);

/// Errors: text that is not what toJson writes, a value that is unknown or out of range.
ViewState viewStateFrom(const std::string& json);

}  // namespace radlab
