#include "grader/judge/PictureVerdict.h"

#include <cstdio>

#include "base/Error.h"
#include "base/ImageFile.h"

namespace radlab::grader {

namespace {

Picture besideNearestReference(const ManifestCheck& line, const Image& found) {
    Picture best;
    for (const std::string& name : line.references) {
        const Image reference = readImage(referenceFolder() + "/" + name);
        if (reference.width() != found.width() || reference.height() != found.height())
            throw Error(name + ": the reference image has another size than the picture: make it anew");
        const double rms = rmsDifference(reference, found);
        if (best.reference.empty() || rms < best.rms)
            best = {line.name, reference, found, differencePicture(reference, found), rms, line.tolerance};
    }
    return best;
}

std::string rmsText(const Picture& picture) {
    char text[160];
    std::snprintf(text, sizeof text, "the picture differs from the reference by %.4f RMS, expected at most %.4f",
                  picture.rms, picture.tolerance);
    return text;
}

}  // namespace

PictureVerdict judgePicture(const ManifestCheck& line, const PictureCase& picture, const std::vector<Step>& steps,
                            const CheckRun& run) {
    for (const StepAnswer& answer : run.answers) {
        if (answer.stop.kind == Stop::Kind::none) continue;
        if (answer.stop.kind == Stop::Kind::machine) return {Status::error, answer.stop.text, {}};
        if (answer.stop.kind == Stop::Kind::notImplemented)
            return {Status::notStarted, answer.stop.text + " is not written yet", {}};
        return {Status::fail, "no picture: " + stopText(steps.front().function, answer.stop), {}};
    }
    if (!run.cause.empty()) return {Status::fail, "no picture: " + run.cause, {}};
    PictureVerdict verdict;
    verdict.picture = besideNearestReference(line, picture.draw(steps, run.answers));
    verdict.message = picture.problem ? picture.problem(steps, run.answers) : "";
    if (verdict.message.empty() && !(verdict.picture->rms <= verdict.picture->tolerance))
        verdict.message = rmsText(*verdict.picture);
    verdict.status = verdict.message.empty() ? Status::pass : Status::fail;
    return verdict;
}

}  // namespace radlab::grader
