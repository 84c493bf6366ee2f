#include "study/StudyPage.h"

#include <array>

#include <kainjow/mustache.hpp>

#include "base/Error.h"
#include "base/Warning.h"
#include "base/WholeFile.h"
#include "display/FalseColor.h"
#include "study/PlotScript.h"
#include "study/StudyPictures.h"
#include "study/StudyPlots.h"
#include "study/Wording.h"

namespace radlab::study {

namespace {

using kainjow::mustache::data;
using Rows = std::vector<const Measurement*>;

constexpr std::array<double, 5> errorsAsked = {0.1, 0.03, 0.01, 0.003, 0.001};

struct ErrorText {
    const char* file;
    const char* title;
    const char* text;
    ErrorKind kind;
};

constexpr ErrorText wholeText{"whole", "The whole error",
                              "Against the light itself, found on a mesh so fine that it no longer matters: what the "
                              "patches cannot show counts, too.",
                              wholeError};
constexpr ErrorText solverText{
    "solver", "The error of the solver",
    "Against the best solution on the same patches: what the method itself gets wrong, whatever the patches show.",
    solverError};

Rows rowsOf(const StudyResults& results, const StudyPlan& plan, const StudyScene& scene) {
    Rows rows;
    for (const Measurement& row : results.rows())
        if (row.plan == plan.name && row.scene == scene.name && row.contents == scene.contents) rows.push_back(&row);
    return rows;
}

struct ScenePlots {
    Plot whole, solver, shots, seconds, memory;
};

ScenePlots plotsOf(const std::string& scene, const Rows& rows, const StudyPlan& plan) {
    const std::string start = "plot_" + scene + "_";
    return {wholePlot(start + wholeText.file, rows, plan), solverPlot(start + solverText.file, rows),
            shotsPlot(start + "shots", rows), secondsPlot(start + "seconds", rows, plan),
            memoryPlot(start + "memory", rows, plan)};
}

data plotData(const std::filesystem::path& folder, const Plot& plot, const std::string& text) {
    data entry;
    if (std::filesystem::exists(folder / wideFile(plot))) {
        entry.set("wide", wideFile(plot));
        entry.set("narrow", narrowFile(plot));
        entry.set("text", text);
        entry.set("shown", true);
    }
    return entry;
}

data frontData(const Rows& front, const ErrorKind& error) {
    data list{data::type::list};
    for (std::size_t i = 0; i < front.size(); ++i) {
        data entry;
        entry.set("number", std::to_string(i + 1));
        entry.set("name", nameOf(*front[i]));
        entry.set("patches", countText(static_cast<double>(front[i]->patches)));
        entry.set("seconds", secondsText(front[i]->seconds));
        entry.set("error", shareText(*error.of(*front[i])));
        list << entry;
    }
    return list;
}

// The largest estimate among the rows: what is measured against it is known to that.
std::string referenceText(const Rows& rows, const ErrorKind& error) {
    double most = 0.0;
    for (const Measurement* row : rows) most = std::max(most, (row->*error.reference).value_or(0.0));
    return shareText(most);
}

data errorData(const std::filesystem::path& folder, const ErrorText& words, const Plot& plot, const Rows& rows) {
    data entry = plotData(folder, plot, words.text);
    entry.set("title", words.title);
    entry.set("about", words.text);
    entry.set("reference", referenceText(rows, words.kind));
    entry.set("front", frontData(bestRows(rows, words.kind), words.kind));
    return entry;
}

void setBest(data& entry, const std::string& name, const Measurement* row) {
    entry.set(name, row ? nameOf(*row) : "none that was measured");
    if (!row) return;
    entry.set(name + "_cost",
              secondsText(row->seconds) + ", " + countText(static_cast<double>(row->patches)) + " patches");
}

data adviceData(const Rows& rows) {
    data list{data::type::list};
    for (const double error : errorsAsked) {
        data entry;
        entry.set("error", shareText(error, 1));
        setBest(entry, "whole", quickestFor(rows, wholeError, error));
        setBest(entry, "solver", quickestFor(rows, solverError, error));
        list << entry;
    }
    return list;
}

data mapData(const std::filesystem::path& folder, const Rows& rows) {
    data list{data::type::list};
    std::vector<std::string> shown;
    for (const Measurement* row : rows) {
        const std::string file = mapFile(row->scene, row->method);
        const bool known = std::find(shown.begin(), shown.end(), file) != shown.end();
        if (known || !row->solverError || !std::filesystem::exists(folder / file)) continue;
        shown.push_back(file);
        data entry;
        entry.set("file", file);
        entry.set("name", row->method);
        list << entry;
    }
    return list;
}

data noteData(const std::vector<std::string>& notes) {
    data list{data::type::list};
    for (const std::string& note : notes) {
        data entry;
        entry.set("text", note);
        list << entry;
    }
    return list;
}

data sceneData(const std::filesystem::path& folder, const StudiedScene& studied, const Rows& rows,
               const ScenePlots& plots) {
    data entry;
    entry.set("name", studied.scene.name);
    data errors{data::type::list};
    errors << errorData(folder, wholeText, plots.whole, rows) << errorData(folder, solverText, plots.solver, rows);
    entry.set("errors", errors);
    entry.set("advice", adviceData(rows));
    data more{data::type::list};
    more << plotData(folder, plots.shots, "What each shot brings.")
         << plotData(folder, plots.seconds,
                     "Time against patches, one setting of each method; n^2 is a time that grows with "
                     "the square of the number of patches.")
         << plotData(folder, plots.memory, "Memory against patches: by how much the program grows while it solves.");
    entry.set("more", more);
    entry.set("maps", mapData(folder, rows));
    entry.set("picture", pictureFile(studied.scene.name));
    entry.set("notes", noteData(studied.report.notes));
    entry.set("has_notes", !studied.report.notes.empty());
    return entry;
}

// The colours of error maps, as CSS has gradients.
std::string scaleColors() {
    constexpr int stops = 8;
    std::string text;
    for (int i = 0; i <= stops; ++i) {
        const glm::vec3 color = 255.0f * heatColor(static_cast<float>(i) / stops);
        char stop[32];
        std::snprintf(stop, sizeof stop, "%srgb(%.0f,%.0f,%.0f)", i == 0 ? "" : ",", static_cast<double>(color.r),
                      static_cast<double>(color.g), static_cast<double>(color.b));
        text += stop;
    }
    return text;
}

std::string page(const StudyPlan& plan, const data& scenes) {
    kainjow::mustache::mustache text(readFile(RADLAB_SOURCE_DIR "/resources/study/index.mustache"));
    if (!text.is_valid()) throw Error({"resources/study/index.mustache"}, text.error_message());
    data values;
    values.set("version", RADLAB_VERSION);
    values.set("plan", plan.name);
    values.set("repeats", std::to_string(plan.repeats));
    values.set("several", plan.repeats > 1);
    values.set("scale", scaleColors());
    values.set("least", shareText(leastShown, 1));
    values.set("most", shareText(mostShown, 1));
    values.set("scenes", scenes);
    return text.render(values);
}

}  // namespace

std::filesystem::path writeStudy(const std::filesystem::path& folder, const StudyPlan& plan,
                                 const std::vector<StudiedScene>& scenes, const StudyResults& results) {
    std::vector<ScenePlots> plots;
    std::vector<Plot> all;
    for (const StudiedScene& studied : scenes) {
        plots.push_back(plotsOf(studied.scene.name, rowsOf(results, plan, studied.scene), plan));
        const ScenePlots& its = plots.back();
        all.insert(all.end(), {its.whole, its.solver, its.shots, its.seconds, its.memory});
    }
    if (!drawPlots(folder, all))
        warn(
            "gnuplot was not found, so there are no plots: install the package gnuplot-nox and run this again, nothing "
            "will be measured twice");
    data list{data::type::list};
    for (std::size_t i = 0; i < scenes.size(); ++i)
        list << sceneData(folder, scenes[i], rowsOf(results, plan, scenes[i].scene), plots[i]);
    writeFile(folder / "index.html", page(plan, list));
    return folder / "index.html";
}

}  // namespace radlab::study
