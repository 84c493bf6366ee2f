#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "study/Measurement.h"

namespace radlab::study {

/// One field of a CSV file: in quotes where it holds a comma, a quote or a line break.
std::string csvField(const std::string& text);

/// The lines of a CSV text, each cut into its fields. A last line without its end is dropped: its writing was cut off.
std::vector<std::vector<std::string>> csvLines(std::string_view text);

/// Measurements as CSV: a line of names, then a line each.
std::string csvOf(const std::vector<Measurement>& rows);

/// What a study has measured so far, kept in a file that is written whole after each measurement.
class StudyResults {
public:
    /// Goes on from the file's rows that are of this version; none where there is no file or all is to be measured anew.
    ///
    /// Errors: a file that is no study's: told with its line.
    StudyResults(std::filesystem::path file, bool fresh);

    const std::vector<Measurement>& rows() const { return measured; }

    /// The row of the same plan, scene, contents, patches, method and setting; nullptr where there is none.
    const Measurement* find(const Measurement& like) const;

    /// Takes a row in place of an older one of the same scene, patches, method and setting, and writes the file.
    void add(const Measurement& row);

private:
    std::filesystem::path file;
    std::vector<Measurement> measured;
};

}  // namespace radlab::study
