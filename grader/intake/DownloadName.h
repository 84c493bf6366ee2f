#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace radlab::grader {

// What the names of downloaded files say. They are made of what students typed: their own names and those of their
// files.

/// A file of Canvas' "submissions.zip".
struct CanvasName {
    std::string name;      ///< "doejane"; empty where names are hidden
    std::string account;   ///< the user ID; "anon_…" where names are hidden
    std::string upload;    ///< the number of the uploaded file, which grows with time
    std::string original;  ///< as the student called it; empty for a text typed in
    bool late = false;
    bool ambiguous = false;  ///< the same name could be another student's, whose name ends in "_" and a number
};

/// Reads "doejane_LATE_123_456_ProgRef-1.cpp" and "doejane_123_text.html".
///
/// @source canvas-lms, lib/content_zipper.rb, get_filename and add_upload_submission
std::optional<CanvasName> canvasName(const std::string& file);

/// A folder or file of Moodle's "Download all submissions".
struct MoodleName {
    std::string name;         ///< of the person or group
    std::string account;      ///< the participant's number; empty for those in no group
    bool holdsFiles = false;  ///< else what was typed in, "onlinetext"
    std::string original;     ///< of a file; empty for a folder
};

/// Reads "Jane Doe_12345_assignsubmission_file_", without the last "_", and with a file's name after it.
///
/// @source moodle, mod/assign/classes/downloader.php, get_student_prefix and load_submissionplugin_filelist
std::optional<MoodleName> moodleName(const std::string& entry);

/// What the student called a file that lies in a class' folder; empty where the layout does not tell.
std::string originalName(const std::string& file);

/// N of "ProgRef-N.cpp", as Canvas calls a file that was handed in again; else 0.
int numberOf(std::string_view file);

/// What a file's ending says about it.
enum class FileKind {
    other,
    archive,         ///< one that is read
    foreignArchive,  ///< one that is not: 7z, rar
};

FileKind kindOf(std::string_view file);

/// A file's name without the ending of an archive or the last ending.
std::string withoutEnding(std::string_view file);

/// The last ending of a file's name: ".cpp"; empty where there is none.
std::string_view endingOf(std::string_view file);

bool sameButForCase(std::string_view a, std::string_view b);

/// How well the name of a file is the one that is wanted; a smaller one is better.
struct NameMatch {
    enum class How { exact, numbered, otherCase };
    How how = How::exact;
    int number = 0;  ///< numberOf the file
};

/// Nothing where the names have nothing to do with one another.
std::optional<NameMatch> matchName(std::string_view found, std::string_view wanted);

}  // namespace radlab::grader
