#include "grader/report/HtmlReport.h"

#include "base/Error.h"

#if __has_include(<kainjow/mustache.hpp>)

#include <algorithm>
#include <cctype>
#include <cstdio>

#include <kainjow/mustache.hpp>

#include "base/ImageFile.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "grader/protocol/PlainText.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

constexpr const char* pageTemplate = "resources/grader/report.mustache";
constexpr std::size_t longestText = 65536;  // bytes of one text; a browser wants no page of many megabytes
constexpr std::size_t longestFileName = 60;
constexpr int smoothWidth = 200;  // a narrower picture is shown enlarged, and its pixels should be seen

std::string shown(const std::string& bytes) {
    const std::string_view start = startOf(bytes, longestText);
    const std::size_t left = bytes.size() - start.size();
    return visibleText(start) + (left > 0 ? "\n… and " + std::to_string(left) + " bytes more" : "");
}

// An empty text would still open a section of the template, so it is not set at all.
void setUnlessEmpty(data& entry, const char* key, const std::string& text) {
    if (!text.empty()) entry.set(key, text);
}

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

// Part of a file's name: letters, digits and dashes of an id, which is not trusted to be one.
std::string fileWord(const std::string& id) {
    std::string word = id.substr(0, longestFileName);
    for (char& letter : word) {
        const auto byte = static_cast<unsigned char>(letter);
        letter = byte < 0x80 && std::isalnum(byte) ? static_cast<char>(std::tolower(byte)) : '-';
    }
    return word;
}

// The class of the style sheet, and the word.
void setStatus(data& entry, Status status) {
    entry.set("status_class", statusText(status));
    entry.set("status_word", statusWord(status));
}

void setMarks(data& entry, double score, double maxScore) {
    if (maxScore <= 0.0) return;
    entry.set("marks", marksText(score) + "/" + marksText(maxScore));
    entry.set("percent", marksText(std::clamp(100.0 * score / maxScore, 0.0, 100.0)));
}

// The page, and the pictures that it needs written beside it.
class Page {
public:
    Page(const Result& judged, std::filesystem::path target) : result(judged), folder(std::move(target)) {}

    std::string text() {
        kainjow::mustache::mustache page(readFile(std::string(RADLAB_SOURCE_DIR "/") + pageTemplate));
        if (!page.is_valid()) throw Error({pageTemplate}, page.error_message());
        data values;
        setVerdict(values);
        data stages{data::type::list};
        for (const StageResult& stage : result.stages)
            if (stage.status != Status::skipped) stages << stageData(stage);
        values.set("stages", stages);
        return page.render(values);
    }

private:
    std::string verdict() const {
        if (hasError(result)) return "The grader or the machine failed. It takes no marks for that.";
        if (nothingStarted(result)) return "Nothing is written yet, so nothing is wrong.";
        const auto isFunction = [](const StageResult& stage) {
            return !isTogether(stage) && stage.status != Status::skipped;
        };
        const auto isRight = [&](const StageResult& stage) {
            return isFunction(stage) && stage.status == Status::pass;
        };
        const auto functions = std::count_if(result.stages.begin(), result.stages.end(), isFunction);
        const auto right = std::count_if(result.stages.begin(), result.stages.end(), isRight);
        if (allRight(result)) return "All functions are right.";
        return std::to_string(right) + " of " + std::to_string(functions) +
               (functions == 1 ? " function is right." : " functions are right.");
    }

    void setVerdict(data& values) const {
        setUnlessEmpty(values, "submission", oneLine(result.submission));
        values.set("verdict", verdict());
        values.set("score", marksText(result.score));
        values.set("max_score", marksText(result.maxScore));
        if (hasError(result)) values.set("not_final", true);
        const double share = result.maxScore > 0.0 ? result.score / result.maxScore : 0.0;
        values.set("score_percent", marksText(std::clamp(100.0 * share, 0.0, 100.0)));
        values.set("next", nextStep(result, true).front());
        values.set("seed", std::to_string(result.seed));
        std::string protections;
        for (const std::string& protection : result.protections)
            protections += (protections.empty() ? "" : ", ") + oneLine(protection);
        setUnlessEmpty(values, "protections", protections);
        if (result.seconds > 0.0) values.set("seconds", durationText(result.seconds));
    }

    data stageData(const StageResult& stage) {
        data entry;
        entry.set("number", std::to_string(stage.number));
        entry.set("name", stageName(stage));
        if (!isTogether(stage)) entry.set("is_function", true);
        setUnlessEmpty(entry, "title", oneLine(stage.title));
        setMarks(entry, stage.score, stage.maxScore);
        setStatus(entry, shownStatus(stage));
        data checks{data::type::list};
        for (const CheckResult& check : stage.checks)
            if (check.status != Status::skipped) checks << checkData(stage, check);
        entry.set("checks", checks);
        return entry;
    }

    data checkData(const StageResult& stage, const CheckResult& check) {
        data entry;
        entry.set("check_name", oneLine(check.name));
        setStatus(entry, check.status);
        // Set in any case: a name that is not found here would be looked up in the stage.
        entry.set("check_marks", check.maxScore > 0.0 ? marksText(check.score) + "/" + marksText(check.maxScore) : "");
        setUnlessEmpty(entry, "message", shown(check.message));
        if (check.diagnosis) setUnlessEmpty(entry, "diagnosis", shown(check.diagnosis->text));
        if (check.status != Status::pass) setUnlessEmpty(entry, "hint", shown(hintOf(check)));
        setUnlessEmpty(entry, "example", shown(check.example));
        setUnlessEmpty(entry, "output", shown(check.output));
        if (check.picture) entry.set("picture", pictureData(stage, check, *check.picture));
        return entry;
    }

    data pictureData(const StageResult& stage, const CheckResult& check, const Picture& picture) {
        const std::string start =
            std::to_string(++pictures) + "-" + fileWord(stage.stage) + "-" + fileWord(check.id) + "-";
        data images{data::type::list};
        const auto add = [&](const Image& image, const std::string& what, const char* title) {
            if (image.empty()) return;
            writeImage(folder / (start + what + ".png"), image);
            data entry;
            entry.set("file", start + what + ".png");
            entry.set("image_title", title);
            entry.set("width", std::to_string(image.width()));
            entry.set("height", std::to_string(image.height()));
            if (image.width() < smoothWidth) entry.set("small", true);
            images << entry;
        };
        add(picture.reference, "reference", "reference");
        add(picture.found, "yours", "yours");
        add(picture.difference, "difference", "difference");
        data entry;
        entry.set("images", images);
        setUnlessEmpty(entry, "caption", oneLine(picture.caption));
        entry.set("rms", figure(picture.rms));
        entry.set("tolerance", figure(picture.tolerance));
        return entry;
    }

    const Result& result;
    std::filesystem::path folder;
    int pictures = 0;
};

}  // namespace

std::filesystem::path writeHtmlReport(const Result& result, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error({folder.string()}, "the folder cannot be made: " + failure.message());
    const std::string page = Page(result, folder).text();
    writeFile(folder / "index.html", page);
    return folder / "index.html";
}

}  // namespace radlab::grader

#else

namespace radlab::grader {

std::filesystem::path writeHtmlReport(const Result&, const std::filesystem::path& folder) {
    throw Error({folder.string()},
                "this build has no kainjow-mustache, so it cannot write the page: install it and build again");
}

}  // namespace radlab::grader

#endif
