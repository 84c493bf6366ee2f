#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace radlab::grader {

/// A small change to the solution that makes a wrong program, or a right one in another style.
struct Mutant {
    std::string stage;  ///< the function that it changes
    std::string id;     ///< unlike all others of its stage
    bool wrong = true;
    std::vector<std::string> names;    ///< the diagnoses that name the mistake; empty where none is expected to
    std::string source;                ///< the whole file with the change made
    std::string file = "ProgRef.cpp";  ///< its name, of an extension its own
};

/// All mutants of a folder of .json files, made from the solution, or from the files of a folder of solutions.
///
/// A file has "stage", "wrong" and "right"; each of their entries an "id" and a change: "replace", pairs of a text that
/// occurs exactly once and its replacement; or "function", names of functions with the lines that take the place of
/// their definition.
/// Errors: with file and id, a text that does not occur once, a function that is not there, a file of another form.
std::vector<Mutant> readMutants(const std::filesystem::path& folder, const std::filesystem::path& solution);

/// Those of the six functions, by the folder and the solution of the project.
std::vector<Mutant> projectMutants();

/// Those of the extensions: each .json file of grader/mutants/extensions names its solution's file, too.
std::vector<Mutant> extensionMutants();

}  // namespace radlab::grader
