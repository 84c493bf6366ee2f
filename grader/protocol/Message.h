#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "grader/protocol/State.h"

namespace radlab::grader {

/// What the worker does in one step: prepares the state, calls one function of the submission, and answers.
struct Step {
    std::string function;        ///< its name; "solve" for the whole loop; "" to load the submission alone
    std::optional<State> state;  ///< published before the call; without one, what the step before left is used
    std::vector<Vec3f> unshot;   ///< replaces unshot_rad of every patch before the call; empty: as it is
    int shooter = -1;  ///< index of the argument of distributeEnergy, and of what maxenergy_patch's stand-in returns
    bool standIns = true;       ///< the worker stands in for maxenergy_patch and renderPatchIDs where others call them
    int hemicubeSize = 0;       ///< edge of the hemicube's top face in pixels, for calcFF and for solving by hemicube
    glm::mat4 view{1.0f};       ///< clip coordinates from world coordinates, for renderPatchIDs
    int width = 0, height = 0;  ///< of the picture that renderPatchIDs draws, in pixels
    bool analytic = true;       ///< how "solve" finds form factors
    int shots = 0;              ///< how often "solve" shoots
    int samples = 0;            ///< of an extension: rays to send, or samples along each side of a pixel
    std::vector<Vec3f> mirror;  ///< of an extension: point, normal and reflectance; the mirror is the patch `shooter`
    std::uint64_t seed = 0;     ///< of an extension's random numbers
    bool inFloats = false;      ///< the picture is one of floats, not of IDs
    std::vector<std::string> wanted;  ///< the members that the answer brings: "patch.formF", "corner.color"
};

/// Whether a step needs OpenGL.
bool draws(const Step& step);

/// A judge's request to a worker.
struct Request {
    std::uint64_t nonce = 0;  ///< comes back in every answer
    std::vector<Step> steps;
};

/// Why a step ended before its function returned.
struct Stop {
    enum class Kind {
        none,
        notImplemented,  ///< the stub is still there; text is its function
        error,           ///< the framework refused what the submission asked for; text says what
        exception,       ///< another exception left the function
        missing,         ///< the submission has no such function
        load,            ///< the submission cannot be loaded; text is the dynamic linker's
        machine,         ///< the worker could not do its part; text says why
    };
    Kind kind = Kind::none;
    std::string text;
};

/// A call of Hemicube::renderScene or readIndexBuffer that the submission made.
struct HemicubeCall {
    bool reads = false;  ///< readIndexBuffer; else renderScene with the three vectors
    Vec3f eye{0.0f}, up{0.0f}, direction{0.0f};
};

/// What a step left behind.
struct StepAnswer {
    Stop stop;
    int returned =
        0;        ///< index of the patch returned, -1 for nullptr, -2 for something else; 0 or 1 of distributeEnergy
    State state;  ///< the members that were wanted, the others as they were made
    std::vector<std::uint8_t> pixels;  ///< red, green, blue, row by row from the bottom
    std::vector<Vec3f> picture;        ///< row by row from the top; of a picture in floats
    std::vector<HemicubeCall> calls;
    int shots = 0;  ///< made by "solve"
};

/// Names of all members of State that travel: "patch.area", "corner.position".
std::vector<std::string> memberNames();

/// A request as it travels; members of a state that are all as a patch or vertex is made do not.
std::string requestToCbor(std::uint64_t nonce, const std::vector<Step>& steps);

/// Errors: what is no request.
Request requestFromCbor(std::string_view bytes);

/// One answer with its length before it, as it is written to the judge.
std::string toRecord(const StepAnswer& answer, std::uint64_t nonce, std::size_t step,
                     const std::vector<std::string>& wanted);

/// The answers that a worker wrote, as far as they are whole, in order and carry the nonce.
///
/// Nothing in bytes is trusted: a record that is not as it should be ends the list.
/// @param steps  what was asked: says how many patches and which members an answer must have
std::vector<StepAnswer> answersFromRecords(std::string_view bytes, std::uint64_t nonce, const std::vector<Step>& steps);

}  // namespace radlab::grader
