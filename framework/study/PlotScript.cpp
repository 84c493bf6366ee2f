#include "study/PlotScript.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <glm/glm.hpp>

#include "base/Error.h"
#include "base/WholeFile.h"
#include "study/Command.h"
#include "study/Wording.h"

namespace radlab::study {

namespace {

// A plot's size in pixels, and the space around its axes.
struct Sheet {
    int width, height, font;
    double left, right, bottom, top;
};

constexpr Sheet wide{860, 500, 14, 92, 212, 58, 44}, narrow{400, 470, 11, 64, 148, 50, 40};

// Colours that the colour-blind tell apart; kin have one colour, and the course's are dashed.
// @source [OkabeIto2008]
struct Style {
    const char* method;
    const char* color;
    int dash, mark;
};

constexpr std::array<Style, 13> styles = {{{"point", "#777777", 1, 7},
                                           {"polygon", "#000000", 1, 5},
                                           {"exact", "#0072B2", 1, 9},
                                           {"visibility", "#0072B2", 1, 9},
                                           {"hemisphere", "#009E73", 1, 11},
                                           {"hemicube", "#D55E00", 1, 5},
                                           {"hierarchical", "#CC79A7", 1, 13},
                                           {"shooting", "#56B4E9", 1, 7},
                                           {"shooting + ambient", "#56B4E9", 2, 6},
                                           {"paths", "#E69F00", 1, 9},
                                           {"course formula", "#777777", 2, 6},
                                           {"course hemicube", "#D55E00", 2, 4},
                                           {"course by shots", "#000000", 2, 8}}};

const Style& styleOf(const std::string& method) {
    const auto found =
        std::find_if(styles.begin(), styles.end(), [&](const Style& style) { return method == style.method; });
    return found == styles.end() ? styles[1] : *found;
}

std::string inQuotes(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
    return result + "'";
}

std::string textOf(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string ticText(double value, Unit unit) {
    switch (unit) {
        case Unit::share: return textOf(100.0 * value) + " %%";  // tics are formats
        case Unit::seconds: return value < 0.1 ? textOf(1000.0 * value) + " ms" : textOf(value) + " s";
        case Unit::bytes: return value < 1e9 ? textOf(value / 1e6) + " MB" : textOf(value / 1e9) + " GB";
        default: return countText(value);
    }
}

class Drawing {
public:
    Drawing(const Plot& what, const Sheet& on, std::string name) : plot(what), sheet(on), file(std::move(name)) {
        for (const Curve& curve : plot.curves) {
            if (curve.points.empty()) continue;
            curves.push_back(curve);
            for (const glm::dvec2& point : curve.points) widenTo(point);
            for (const glm::dvec2& point : curve.loose) widenTo(point);
        }
    }

    std::string script() {
        if (curves.empty()) return "";
        frame();
        axis("x", plot.x, low.x, high.x);
        axis("y", plot.y, low.y, high.y);
        names();
        numbers();
        data();
        return text;
    }

private:
    void widenTo(const glm::dvec2& point) {
        low = glm::min(low, point / glm::dvec2(2.2, 1.6));  // the front's numbers stand on the left
        high = glm::max(high, point * 1.6);
    }

    void frame() {
        text += "reset\nset terminal svg size " + std::to_string(sheet.width) + "," + std::to_string(sheet.height) +
                " dynamic noenhanced font 'sans-serif," + std::to_string(sheet.font) +
                "' background '#ffffff' linewidth 1.3\nset output " + inQuotes(file) + "\nunset key\n";
        text += "set lmargin at screen " + textOf(sheet.left / sheet.width) + "\nset rmargin at screen " +
                textOf(1.0 - sheet.right / sheet.width) + "\nset bmargin at screen " +
                textOf(sheet.bottom / sheet.height) + "\nset tmargin at screen " +
                textOf(1.0 - sheet.top / sheet.height) + "\n";
        text +=
            "set border 3 lc rgb '#555555'\nset grid lc rgb '#e4e4e4' lt 1 lw 0.6\nset tics nomirror out scale 0.5\n";
        text += "set label 1 " + inQuotes(plot.y.title) + " at screen 0.012,screen " +
                textOf(1.0 - 0.4 * sheet.top / sheet.height) + " left\nset label 2 " + inQuotes(plot.x.title) +
                " at graph 0.5,screen " + textOf(0.25 * sheet.bottom / sheet.height) + " center\n";
    }

    void axis(const std::string& name, const Axis& of, double least, double most) {
        text += "set logscale " + name + "\nset " + name + "range [" + textOf(least) + ":" + textOf(most) + "]\nset " +
                name + "tics (";
        const char* comma = "";
        const double inWidth = name == "x" ? (sheet.width - sheet.left - sheet.right) / (5.0 * sheet.font) : 99.0;
        const std::vector<double> tics = ticsBetween(least, most);
        const auto each = static_cast<std::size_t>(std::ceil(static_cast<double>(tics.size()) / inWidth));
        for (std::size_t i = 0; i < tics.size(); i += each) {
            text += comma + inQuotes(ticText(tics[i], of.unit)) + " " + textOf(tics[i]);
            comma = ", ";
        }
        text += ")\n";
    }

    glm::dvec2 inGraph(const glm::dvec2& point) const { return glm::log(point / low) / glm::log(high / low); }
    double graphHeight() const { return sheet.height - sheet.bottom - sheet.top; }

    // The names on the right, each with a thin line from the curve's last point.
    void names() {
        std::vector<double> ends;
        for (const Curve& curve : curves) ends.push_back(inGraph(curve.points.back()).y);
        const std::vector<double> places = spreadOut(ends, 1.25 * sheet.font / graphHeight(), 0.0, 1.0);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const glm::dvec2 end = inGraph(curves[i].points.back());
            const std::string color = std::string(" rgb '") + styleOf(curves[i].method).color + "'",
                              at = textOf(places[i]);
            text += "set label " + inQuotes(curves[i].label) + " at graph 1.05,graph " + at + " left tc" + color + "\n";
            text += "set arrow from graph " + textOf(end.x) + "," + textOf(end.y) + " to graph 1.04," + at +
                    " nohead back dt 3 lw 0.6 lc" + color + "\n";
        }
    }

    // The numbers of the front, below it and to the left, where no point is.
    void numbers() {
        std::vector<double> heights;
        const double below = 0.9 * sheet.font / graphHeight();
        for (const glm::dvec2& point : plot.front) heights.push_back(-(inGraph(point).y - below));
        heights = spreadOut(heights, 1.0 * sheet.font / graphHeight(), -1.0, 0.0);
        for (std::size_t i = 0; i < heights.size(); ++i)
            text += "set label '" + std::to_string(i + 1) + "' at graph " +
                    textOf(inGraph(plot.front[i]).x - 0.6 * sheet.font / (sheet.width - sheet.left - sheet.right)) +
                    "," + textOf(-heights[i]) + " right front\n";
    }

    void table(const std::string& name, const std::vector<glm::dvec2>& points) {
        text += "$" + name + " << END\n";
        for (const glm::dvec2& point : points) text += textOf(point.x) + " " + textOf(point.y) + "\n";
        text += "END\n";
    }

    void data() {
        std::string drawn;
        if (!plot.front.empty()) {
            table("front", plot.front);
            drawn = "$front with steps lw 7 lc rgb '#dcdcdc', ";
        }
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const std::string number = std::to_string(i);
            table("c" + number, curves[i].points);
            drawn += (i == 0 ? "$c" : ", $c") + number + " with linespoints" + markOf(styleOf(curves[i].method));
            if (curves[i].loose.empty()) continue;
            table("l" + number, curves[i].loose);
            drawn += ", $l" + number + " with points" + markOf(styleOf(curves[i].method));
        }
        if (!plot.front.empty()) drawn += ", $front with points pt 6 ps 1.4 lw 1.2 lc rgb '#000000'";
        text += "plot " + drawn + "\nunset output\n";
    }

    static std::string markOf(const Style& style) {
        return " lw 1.4 dt " + std::to_string(style.dash) + " pt " + std::to_string(style.mark) + " ps 0.6 lc rgb '" +
               style.color + "'";
    }

    const Plot& plot;
    const Sheet& sheet;
    const std::string file;
    std::vector<Curve> curves;
    glm::dvec2 low{HUGE_VAL}, high{0.0};
    std::string text;
};

}  // namespace

std::string wideFile(const Plot& plot) { return plot.file + ".svg"; }
std::string narrowFile(const Plot& plot) { return plot.file + "_narrow.svg"; }

std::string plotScript(const std::vector<Plot>& plots, const std::string& ending) {
    std::string script;
    for (const Plot& plot : plots)
        script += Drawing(plot, wide, wideFile(plot) + ending).script() +
                  Drawing(plot, narrow, narrowFile(plot) + ending).script();
    return script;
}

bool drawPlots(const std::filesystem::path& folder, const std::vector<Plot>& plots) {
    const std::string unfinished = ".part";
    const std::filesystem::path whole = std::filesystem::absolute(folder), script = whole / "plots.gp";
    writeFile(script, "cd " + inQuotes(whole.string()) + "\n" + plotScript(plots, unfinished));
    const auto status = runCommand({"gnuplot", script.string()});
    if (!status) return false;
    if (*status != 0) throw Error({script.string()}, "gnuplot gave up with exit code " + std::to_string(*status));
    for (const Plot& plot : plots)
        for (const std::string& file : {wideFile(plot), narrowFile(plot)})
            if (std::filesystem::exists(folder / (file + unfinished)))
                std::filesystem::rename(folder / (file + unfinished), folder / file);
    writeFile(script, plotScript(plots));  // the same for people: run in the folder, it draws the plots again
    return true;
}

}  // namespace radlab::study
