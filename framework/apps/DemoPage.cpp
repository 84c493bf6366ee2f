#include "apps/DemoPage.h"

#include <kainjow/mustache.hpp>

#include "base/Error.h"
#include "base/ImageFile.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "display/Label.h"

namespace radlab {

namespace {

using kainjow::mustache::data;

constexpr int sheetColumns = 5;

std::string paragraph(const DemoPicture& picture) {
    if (picture.outcome != DemoPicture::Outcome::made) return picture.problem;
    data figures;
    for (const auto& [name, value] : picture.figures) figures.set(name, value);
    kainjow::mustache::mustache text(picture.words.text);
    text.set_custom_escape([](const std::string& plain) { return plain; });  // the page escapes it
    return text.render(figures);
}

data pictureData(const Demo& demo) {
    data list{data::type::list};
    for (const DemoPicture& picture : demo.pictures) {
        data entry;
        entry.set("file", picture.words.file);
        entry.set("title", picture.words.title);
        entry.set("text", paragraph(picture));
        if (*picture.words.function) entry.set("function", picture.words.function);
        list << entry;
    }
    return list;
}

data shotData(const Demo& demo) {
    data list{data::type::list};
    for (std::size_t i = 0; i < demo.shots.size(); ++i) {
        data entry;
        entry.set("file", demo.shots[i].file);
        entry.set("shots", std::to_string(demo.shots[i].shots));
        entry.set("unshot", demo.shots[i].unshot);
        entry.set("separator", i + 1 < demo.shots.size() ? "," : "");
        list << entry;
    }
    return list;
}

std::string page(const Demo& demo) {
    kainjow::mustache::mustache text(readFile(RADLAB_SOURCE_DIR "/resources/demo/index.mustache"));
    if (!text.is_valid()) throw Error({"resources/demo/index.mustache"}, text.error_message());
    data values;
    values.set("pictures", pictureData(demo));
    values.set("seconds", durationText(demo.seconds));
    if (!demo.shots.empty()) {
        values.set("has_shots", true);
        values.set("shots", shotData(demo));
        values.set("last", std::to_string(demo.shots.size() - 1));
        values.set("last_file", demo.shots.back().file);
    }
    return text.render(values);
}

Image sheet(const Demo& demo) {
    std::vector<Image> small;
    std::vector<std::string> captions;
    for (const DemoPicture& picture : demo.pictures) {
        small.push_back(picture.image.shrunk(2));
        captions.emplace_back(picture.words.caption);
    }
    return contactSheet(small, captions, sheetColumns);
}

}  // namespace

std::filesystem::path writeDemo(const Demo& demo, const std::filesystem::path& folder) {
    makeFolder(folder);
    for (const DemoPicture& picture : demo.pictures) writeImage(folder / picture.words.file, picture.image);
    for (const DemoShot& shot : demo.shots) writeImage(folder / shot.file, shot.image);
    if (!demo.shots.empty()) writeImage(folder / "shots_strip.png", demo.strip);
    writeImage(folder / "contact_sheet.png", sheet(demo));
    writeFile(folder / "index.html", page(demo));
    return folder / "index.html";
}

}  // namespace radlab
