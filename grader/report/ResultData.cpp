#include "grader/report/ResultData.h"

#include <cstdio>

#include "base/ProgressBar.h"
#include "grader/report/Page.h"
#include "grader/report/TextLines.h"
#include "grader/report/Wording.h"

namespace radlab::grader {

namespace {

using kainjow::mustache::data;

constexpr int smoothWidth = 200;  // a narrower picture is shown enlarged, and its pixels should be seen

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

data imageData(const ShownImage& image) {
    data entry;
    entry.set("file", image.address);
    entry.set("image_title", oneLine(image.title));
    entry.set("width", std::to_string(image.width));
    entry.set("height", std::to_string(image.height));
    if (image.width < smoothWidth) entry.set("small", true);
    return entry;
}

data pictureData(const ShownPicture& picture) {
    data images{data::type::list};
    for (const ShownImage& image : picture.images) images << imageData(image);
    data entry;
    entry.set("images", images);
    setUnlessEmpty(entry, "caption", oneLine(picture.caption));
    entry.set("rms", figure(picture.rms));
    entry.set("tolerance", figure(picture.tolerance));
    return entry;
}

data checkData(const StageResult& stage, const CheckResult& check, const PictureOf& pictureOf) {
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
    if (const std::optional<ShownPicture> picture = pictureOf(stage, check))
        entry.set("picture", pictureData(*picture));
    return entry;
}

data stageData(const StageResult& stage, const PictureOf& pictureOf) {
    data entry;
    entry.set("number", std::to_string(stage.number));
    entry.set("name", stageName(stage));
    if (!isTogether(stage) && !isExtension(stage)) entry.set("is_function", true);
    setUnlessEmpty(entry, "title", (isExtension(stage) ? "extension, beside the marks: " : "") + oneLine(stage.title));
    setMarks(entry, stage.score, stage.maxScore);
    setStatus(entry, shownStatus(stage));
    data checks{data::type::list};
    for (const CheckResult& check : stage.checks)
        if (check.status != Status::skipped) checks << checkData(stage, check, pictureOf);
    entry.set("checks", checks);
    return entry;
}

void setVerdict(data& values, const Result& result) {
    values.set("verdict", verdictText(result));
    values.set("next", nextStep(result, true).front());
    data marks;
    marks.set("score", marksText(result.score));
    marks.set("max_score", marksText(result.maxScore));
    marks.set("score_percent", percentText(result.score, result.maxScore));
    if (hasError(result)) marks.set("not_final", true);
    if (!isOfExtensions(result)) values.set("has_marks", marks);
}

void setCompiler(data& values, const Result& result) {
    if (result.compiler.empty()) return;
    data compiler;
    compiler.set("said", shown(result.compiler));
    if (!result.compiled) compiler.set("failed", true);
    values.set("compiler", compiler);
}

void setOrigin(data& values, const Result& result) {
    data origin;
    setUnlessEmpty(origin, "submission", oneLine(result.submission));
    origin.set("seed", std::to_string(result.seed));
    setUnlessEmpty(origin, "protections", listText(result.protections));
    if (result.seconds > 0.0) origin.set("seconds", durationText(result.seconds));
    values.set("origin", origin);
}

}  // namespace

void setResult(data& values, const Result& result, const PictureOf& pictureOf) {
    setVerdict(values, result);
    setCompiler(values, result);
    setOrigin(values, result);
    data stages{data::type::list};
    for (const StageResult& stage : result.stages)
        if (stage.status != Status::skipped) stages << stageData(stage, pictureOf);
    for (const StageResult& extension : result.extensions)
        if (extension.status != Status::skipped) stages << stageData(extension, pictureOf);
    if (!stages.is_empty_list()) values.set("has_stages", true);
    values.set("stages", stages);
}

}  // namespace radlab::grader
