#include "grader/stages/CaseText.h"

#include <algorithm>
#include <cstdio>

namespace radlab::grader {

namespace {

// Larger cases are not printed: nobody would paste them.
constexpr std::size_t mostPatches = 8;
constexpr std::size_t textColumns = 86;

std::string number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
    std::string written = text;
    if (written.find_first_of(".en") == std::string::npos) written += ".0";
    return written + "f";
}

std::string vector(const Vec3f& v) {
    if (v.x == v.y && v.y == v.z) return "Vec3f(" + number(v.x) + ")";
    return "Vec3f(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

std::string cornersOf(const MyPolygon& patch) {
    std::string text;
    for (int i = 0; i < patch.vertices; ++i) text += (i ? ", " : "") + std::to_string(patch.vertex[i]);
    return ".vertices = " + std::to_string(patch.vertices) + ", .vertex = {" + text + "}";
}

// Designated initialisers stand in the order of MyPolygon's members.
std::string initialiser(const MyPolygon& patch, const std::vector<std::string>& inputs) {
    std::string text;
    const auto add = [&](const std::string& name, const std::string& value) {
        if (std::find(inputs.begin(), inputs.end(), name) == inputs.end()) return;
        text += (text.empty() ? "" : ", ") + (name == "corners" ? value : "." + name + " = " + value);
    };
    add("corners", cornersOf(patch));
    add("diffuse", vector(patch.diffuse));
    add("emissive", vector(patch.emissive));
    add("normal", vector(patch.normal));
    add("center", vector(patch.center));
    add("area", number(patch.area));
    add("formF", number(patch.formF));
    add("rad", vector(patch.rad));
    add("unshot_rad", vector(patch.unshot_rad));
    add("color", vector(patch.color));
    return "{" + text + "}";
}

// A line broken after commas, what follows indented further.
std::string broken(std::string line) {
    std::string text;
    while (line.size() > textColumns) {
        const std::size_t comma = line.rfind(", ", textColumns - 2);
        if (comma == std::string::npos || comma < 20) break;
        text += line.substr(0, comma + 1) + "\n";
        line = "        " + line.substr(comma + 2);
    }
    return text + line + "\n";
}

std::string list(const std::string& name, const std::vector<std::string>& items) {
    std::string text = "    " + name + " = {";
    for (std::size_t i = 0; i < items.size(); ++i) text += (i ? ", " : "") + items[i];
    return broken(text + "};");
}

bool reads(const Stage& stage, const std::string& member) {
    const std::vector<std::string> inputs = stage.inputs();
    return std::find(inputs.begin(), inputs.end(), member) != inputs.end();
}

std::string meshLines(const Stage& stage, const State& state) {
    std::string text = "    radlab::PatchMesh mesh;\n";
    std::vector<std::string> patches, corners;
    for (const MyPolygon& patch : state.patches) patches.push_back(initialiser(patch, stage.inputs()));
    for (const MyVertex& corner : state.corners) corners.push_back("{.position = " + vector(corner.position) + "}");
    text += list("mesh.patches", patches);
    if (reads(stage, "positions"))
        text += list("mesh.corners", corners);
    else if (reads(stage, "corners"))
        text += "    mesh.corners.resize(" + std::to_string(state.corners.size()) + ");\n";
    return text + "    mesh.publish();\n";
}

std::string callOf(const Stage& stage, const Step& step) {
    const std::string name = stage.function();
    if (name == "distributeEnergy")
        return name + (step.shooter < 0 ? "(nullptr)" : "(polygons[" + std::to_string(step.shooter) + "])");
    return name + (name == "calcFF" ? "(&hemicube)" : "()");
}

// The call and the claim that fails: about what is returned, or about what is left behind.
std::string claimLines(const Stage& stage, const Step& step, std::size_t value, const std::string& found,
                       const std::string& expected) {
    const std::string name = stage.name(step, value), call = callOf(stage, step);
    if (name.find("returned") != std::string::npos)
        return "    CHECK(" + call + " == " + expected + ");  // found " + found + "\n";
    const std::string called = "    " + call + ";\n";
    if (name.find(' ') != std::string::npos)  // in words: nothing that C++ could ask for
        return called + "    // " + name + ": found " + found + ", expected " + expected + "\n";
    return called + "    CHECK(" + name + " == doctest::Approx(" + expected + "));  // found " + found + "\n";
}

}  // namespace

std::string caseAsCode(const Stage& stage, const Case& asked, std::size_t step, const State& before, std::size_t value,
                       double found, double expected) {
    const Step& call = asked.steps[step];
    // An extension takes more than patches: rays, views and passes, which a test would have to make first.
    if (call.samples > 0 || call.inFloats) return "";
    if (before.patches.size() > mostPatches) return "";
    std::string text = "TEST_CASE(\"" + stage.function() + ": " + asked.what + "\") {\n" + meshLines(stage, before);
    if (call.hemicubeSize) text += "    Hemicube hemicube(" + std::to_string(call.hemicubeSize) + ");\n";
    return text + claimLines(stage, call, value, stage.show(call, value, found), stage.show(call, value, expected)) +
           "}\n";
}

}  // namespace radlab::grader
