#include "grader/report/HtmlReport.h"

#include <cctype>

#include "base/Error.h"
#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "grader/report/Page.h"
#include "grader/report/ResultData.h"

namespace radlab::grader {

namespace {

constexpr std::size_t longestFileName = 60;

// Part of a file's name: letters, digits and dashes of an id, which is not trusted to be one.
std::string fileWord(const std::string& id) {
    std::string word = id.substr(0, longestFileName);
    for (char& letter : word) {
        const auto byte = static_cast<unsigned char>(letter);
        letter = byte < 0x80 && std::isalnum(byte) ? static_cast<char>(std::tolower(byte)) : '-';
    }
    return word;
}

// Writes the pictures of the checks beside the page.
class PictureFiles {
public:
    explicit PictureFiles(std::filesystem::path target) : folder(std::move(target)) {}

    std::optional<ShownPicture> write(const StageResult& stage, const CheckResult& check) {
        if (!check.picture) return std::nullopt;
        const Picture& picture = *check.picture;
        const std::string start = std::to_string(++count) + "-" + fileWord(stage.stage) + "-" + fileWord(check.id);
        ShownPicture shown{picture.caption, picture.rms, picture.tolerance, {}};
        add(shown, picture.reference, start, "reference");
        add(shown, picture.found, start, "yours");
        add(shown, picture.difference, start, "difference");
        return shown;
    }

private:
    void add(ShownPicture& shown, const Image& image, const std::string& start, const char* title) const {
        if (image.empty()) return;
        const std::string name = start + "-" + title + ".png";
        writeImage(folder / name, image);
        shown.images.push_back({name, title, image.width(), image.height()});
    }

    std::filesystem::path folder;
    int count = 0;
};

}  // namespace

std::filesystem::path writeHtmlReport(const Result& result, const std::filesystem::path& folder) {
    makeFolder(folder);
    PictureFiles pictures(folder);
    kainjow::mustache::data values;
    values.set("images_from", "'self' file:");
    setResult(values, result,
              [&](const StageResult& stage, const CheckResult& check) { return pictures.write(stage, check); });
    writeFile(folder / "index.html", renderPage("report.mustache", values));
    return folder / "index.html";
}

}  // namespace radlab::grader
