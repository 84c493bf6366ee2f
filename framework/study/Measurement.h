#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace radlab::study {

/// What one setting of one method cost on one mesh, and how far off it was.
struct Measurement {
    std::string version, plan;    ///< of radlab, and of the settings: rows of others are measured anew
    std::string scene, contents;  ///< the file's name without its ending, and a hash of what is in it
    std::size_t wanted = 0;       ///< patches asked for
    std::size_t patches = 0;      ///< patches that there are
    std::string method, setting;
    double level = 0.0;  ///< the setting's number: rays, pixels, shots; larger is dearer
    std::size_t repeats = 0;
    double seconds = 0.0, fastest = 0.0, slowest = 0.0;  ///< from the mesh to the radiosities: the median, and the ends
    std::optional<double> solverError;                   ///< against the reference on this mesh: RMS over RMS
    std::optional<double> solverReference;               ///< estimated error of that reference
    std::optional<double> wholeError;                    ///< against a mesh so fine that it no longer matters
    std::optional<double> wholeReference;                ///< estimated error of the solution on that mesh
    std::optional<double> bytes;                         ///< by which the program grew at most
    std::size_t shots = 0;                               ///< of methods that shoot
};

/// Method and setting in words.
inline std::string nameOf(const Measurement& row) {
    return row.setting.empty() ? row.method : row.method + ", " + row.setting;
}

/// One of the two errors, with that of what it was measured against.
struct ErrorKind {
    std::optional<double> Measurement::*found;
    std::optional<double> Measurement::*reference;

    /// The error as far as it is known: not below that of the reference, nor below `least`.
    std::optional<double> of(const Measurement& row) const {
        if (!(row.*found)) return {};
        return std::max({*(row.*found), (row.*reference).value_or(0.0), least});
    }

    static constexpr double least = 1e-6;  // less matters to nobody
};

constexpr ErrorKind solverError{&Measurement::solverError, &Measurement::solverReference};
constexpr ErrorKind wholeError{&Measurement::wholeError, &Measurement::wholeReference};

}  // namespace radlab::study
