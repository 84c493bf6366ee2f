#pragma once

#include <string>

#include "apps/SceneInput.h"
#include "engine/FormFactors.h"

namespace radlab {

/// How a program was told to find form factors.
struct FormFactorFlags {
    std::string method = "auto";
    std::size_t rays = 0;
    int size = 256;
};

/// Adds --method, --rays and --size to a program's flags.
void addFormFactorFlags(CLI::App& app, FormFactorFlags& flags);

/// Errors: no such method.
engine::FormFactorOptions optionsOf(const FormFactorFlags& flags);

/// Warns where a method cannot hold what a scene has: hidden patches, or pairs that are near.
void warnOfLimits(const SceneInput& input, engine::Method method);

/// What a matrix of the form factors takes, in words to print before it is spent.
std::string storageOf(const SceneInput& input);

/// The form factors of a scene's patches, with a progress bar; its occlusion decides what `auto` is; limits of the method are warned of.
engine::FormFactorMatrix runFormFactors(const SceneInput& input, engine::FormFactorOptions options,
                                        engine::FormFactorReport& report);

}  // namespace radlab
