#include <string_view>
#include <utility>

#include "grader/intake/Folder.h"
#include "grader/intake/Hash.h"
#include "grader/intake/Submission.h"
#include "grader/intake/Unpack.h"

namespace radlab::grader {

namespace {

bool isBlank(std::string_view text) { return text.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos; }

// Why a compiler will not read a file as its author sees it; empty where it will.
std::string oddityOf(std::string_view contents) {
    for (const char* mark : {"\xff\xfe", "\xfe\xff"})
        if (contents.substr(0, 2) == mark) return "is in UTF-16: save it as UTF-8";
    return contents.find('\0') == std::string_view::npos ? "" : "holds NUL bytes, which no source text does";
}

class Intake {
public:
    Intake(const Submission& from, const IntakeRules& within)
        : submission(from), rules(within), remarks(within.mostRemarks), nothing(within) {}

    Taken run() {
        for (auto place = submission.places.rbegin(); place != submission.places.rend() && !isComplete(); ++place)
            take(gathered(*place));
        if (!taken.files.count(rules.files.front()) && !isEmpty) tellMissing();
        taken.outcome = outcome();
        if (!taken.files.empty()) taken.hash = hashOf(taken.files);
        taken.remarks = remarks.lines();
        return std::move(taken);
    }

private:
    bool isComplete() const { return taken.files.size() == rules.files.size(); }

    Outcome outcome() const {
        if (taken.files.count(rules.files.front())) return Outcome::graded;
        const bool refused = submission.places.empty() ? !submission.student.remarks.empty() : remarks.refusedAny();
        return refused ? Outcome::refused : Outcome::nothing;
    }

    void tellMissing() {
        const bool refused = remarks.refusedAny();
        std::string found = refused ? "" : "; no other file was handed in";
        if (!nothing.others.empty()) found = "; found instead: " + shownNames(nothing.others, nothing.moreOthers);
        remarks.note((refused ? "no " : "") + rules.files.front() + (refused ? " could be taken" : " is missing") +
                     found);
    }

    void take(Gathered&& from) {
        remarks.add(from.remarks);
        for (const std::string& other : from.others) nothing.addOther(other);
        nothing.moreOthers = nothing.moreOthers || from.moreOthers;
        for (auto& [name, file] : from.files) {
            if (taken.files.count(name)) continue;
            if (isBlank(file.contents)) {
                remarks.note(shownName(file.path) + " is empty");
                isEmpty = isEmpty || name == rules.files.front();
                continue;
            }
            const std::string oddity = oddityOf(file.contents);
            if (!oddity.empty()) remarks.note(shownName(file.path) + " " + oddity);
            taken.files[name] = std::move(file.contents);
        }
    }

    static bool isFolder(const OpenFile& file) {
        struct stat about = {};
        return fstat(file.get(), &about) == 0 && S_ISDIR(about.st_mode);
    }

    Gathered gathered(const std::filesystem::path& place) {
        try {
            const OpenFile file = openPlace(place.string());
            return isFolder(file) ? fromFolder(file) : fromFile(file, place.filename().string());
        } catch (const NotTaken& reason) {
            Gathered none(rules);
            none.remarks.refuse(shownName(place.filename().string()) + ": " + reason.what());
            return none;
        }
    }

    // Moodle hands out a folder a student, which holds the archive that the student packed.
    Gathered fromFolder(const OpenFile& folder) {
        auto [direct, archives] = gatherFolder(folder, rules);
        if (direct.files.count(rules.files.front()) || archives.empty()) return std::move(direct);
        if (archives.size() > 1) {
            direct.remarks.refuse("several archives (" + shownNames(archives) + "): hand in one");
            return std::move(direct);
        }
        try {
            Gathered packed = fromArchive(openBelow(folder, archives.front()), archives.front());
            packed.files.merge(direct.files);
            packed.remarks.add(direct.remarks);
            return packed;
        } catch (const NotTaken& reason) {
            direct.remarks.refuse(shownName(archives.front()) + ": " + reason.what());
            return std::move(direct);
        }
    }

    Gathered fromFile(const OpenFile& file, const std::string& name) {
        const std::string original = originalName(name);
        const std::string& called = original.empty() ? name : original;
        if (kindOf(called) != FileKind::other) return fromArchive(file, called);
        // A file that only its author's name tells from others' is what was asked for, if it is of that kind.
        const std::string& wanted = rules.files.front();
        const bool isWork = original.empty() && sameButForCase(endingOf(name), endingOf(wanted));
        Gathered single(rules);
        Choice choice(rules);
        if (isWork)
            single.files[wanted] = {name, contentsOf(file, rules.mostBytes)};
        else if (choice.wants(called))
            choice.offer({called, contentsOf(file, rules.mostBytes)});
        else
            single.addOther(called);
        choice.finish(single);
        return single;
    }

    Gathered fromArchive(const OpenFile& file, const std::string& name) {
        if (kindOf(name) == FileKind::foreignArchive)
            throw NotTaken("7-Zip and RAR archives are not read: hand in the file itself, a zip or a tar");
        const std::string bytes = contentsOf(file, rules.mostArchive);
        Gathered packed(rules);
        if (bytes.empty())
            packed.remarks.note(shownName(name) + " is empty");
        else
            packed = unpackArchive(bytes, rules);
        return packed;
    }

    const Submission& submission;
    const IntakeRules& rules;
    Remarks remarks;
    Gathered nothing;      // what was found instead
    bool isEmpty = false;  // a file to compile that was found
    Taken taken;
};

}  // namespace

Taken take(const Submission& submission, const IntakeRules& rules) { return Intake(submission, rules).run(); }

}  // namespace radlab::grader
