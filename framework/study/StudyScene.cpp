#include "study/StudyScene.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "base/Error.h"
#include "base/Warning.h"
#include "base/WholeFile.h"
#include "scene/X3dReader.h"

namespace radlab::study {

namespace {

// Letters, digits, _ and -: it becomes part of file names.
std::string plainName(std::string name) {
    for (char& c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        if (!plain) c = '_';
    }
    return name;
}

// @source FNV-1a
std::string hashOf(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    char hexadecimal[20];
    std::snprintf(hexadecimal, sizeof hexadecimal, "%016llx", static_cast<unsigned long long>(hash));
    return hexadecimal;
}

bool isNotMatt(const Face& face) {
    return face.material->specular != Vec3f(0.0f) || face.material->transparency > 0.0f;
}

}  // namespace

StudyScene readStudyScene(const std::filesystem::path& file) {
    StudyScene read{plainName(file.stem().string()), "", readX3d(file)};
    read.contents = hashOf(readFile(file));
    const std::vector<Face>& faces = read.scene.faces;
    if (std::none_of(faces.begin(), faces.end(), [](const Face& face) { return face.material->emits(); }))
        throw Error({file.string()}, "nothing emits light, so there is nothing to measure; expected a face that emits");
    if (std::any_of(faces.begin(), faces.end(), isNotMatt))
        warn(file.string() +
             ": some faces mirror, or let light through: the study takes all of them as matt and opaque");
    return read;
}

std::string pictureFile(const std::string& scene) { return "picture_" + scene + ".png"; }

std::string mapFile(const std::string& scene, const std::string& method) {
    return "map_" + scene + "_" + plainName(method) + ".png";
}

}  // namespace radlab::study
