#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace radlab {

/// How form factors are found.
enum class FormFactorMethod {
    analytic,   ///< by formula, "analytic" in the file
    hemicube,   ///< by drawing patch IDs, "hemicube" in the file
    automatic,  ///< left to the program, "auto" in the file
};

/// The settings of a run, as the course keeps them in Resource.xml.
struct Resource {
    int hemicubeSize = 0;  ///< pixels along an edge of the hemicube, even, 2 to 4096
    FormFactorMethod method = FormFactorMethod::automatic;
    float patchSize = 0;  ///< longest edge of a patch, in the scene's unit
    float lightSize = 0;  ///< longest edge of a patch that emits, in the scene's unit
    std::filesystem::path sceneFile;
};

/// Reads a settings file: a Resource element with one Values element, which holds all five settings.
///
///     <Resource><Values hemicube_size="512" form_factor_method="analytic" patch_subdivision_size="0.25"
///         light_subdivision_size="0.1" file_name="scenes/cornell_1.x3d"/></Resource>
///
/// A relative file_name is looked for beside the settings file, wherever the program was started from.
///
/// @return sceneFile names a file that exists
/// @throws Error for a setting that is missing, unknown or out of range, for anything else in the file, and
///         where there is no scene file
Resource readResource(const std::filesystem::path& file);

/// Reads settings from text, like readResource, but without a look whether the scene file exists.
///
/// @param fileName the name that messages show; a relative file_name is relative to its folder
Resource parseResource(std::string_view text, const std::string& fileName);

}  // namespace radlab
