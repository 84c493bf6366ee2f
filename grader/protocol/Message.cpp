#include "grader/protocol/Message.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/protocol/Cbor.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

constexpr std::size_t deepestMessage = 8;  // of a message: levels of its CBOR, with some to spare

// A member of MyPolygon or MyVertex, which travels as one packed array over all patches or vertices.
struct Member {
    const char* name;
    std::size_t offset, size;
};

#define RADLAB_MEMBER(prefix, type, member) \
    { prefix #member, offsetof(type, member), sizeof(type::member) }

constexpr std::array<Member, 11> patchMembers = {
    {RADLAB_MEMBER("patch.", MyPolygon, vertices), RADLAB_MEMBER("patch.", MyPolygon, vertex),
     RADLAB_MEMBER("patch.", MyPolygon, diffuse), RADLAB_MEMBER("patch.", MyPolygon, emissive),
     RADLAB_MEMBER("patch.", MyPolygon, normal), RADLAB_MEMBER("patch.", MyPolygon, center),
     RADLAB_MEMBER("patch.", MyPolygon, area), RADLAB_MEMBER("patch.", MyPolygon, formF),
     RADLAB_MEMBER("patch.", MyPolygon, rad), RADLAB_MEMBER("patch.", MyPolygon, unshot_rad),
     RADLAB_MEMBER("patch.", MyPolygon, color)}};

constexpr std::array<Member, 4> cornerMembers = {
    {RADLAB_MEMBER("corner.", MyVertex, position), RADLAB_MEMBER("corner.", MyVertex, colorcount),
     RADLAB_MEMBER("corner.", MyVertex, color), RADLAB_MEMBER("corner.", MyVertex, rad)}};

#undef RADLAB_MEMBER

template <class Item>
Json packed(const std::vector<Item>& items, const Member& member) {
    std::vector<std::uint8_t> bytes(items.size() * member.size);
    for (std::size_t i = 0; i < items.size(); ++i)
        std::memcpy(&bytes[i * member.size], reinterpret_cast<const char*>(&items[i]) + member.offset, member.size);
    return Json::binary(std::move(bytes));
}

template <class Item>
void unpack(const Json& json, const Member& member, std::vector<Item>& items) {
    const Json::binary_t& bytes = json.at(member.name).get_binary();
    if (bytes.size() != items.size() * member.size) throw Error(std::string(member.name) + ": wrong size");
    for (std::size_t i = 0; i < items.size(); ++i)
        std::memcpy(reinterpret_cast<char*>(&items[i]) + member.offset, &bytes[i * member.size], member.size);
}

template <class Visit>
void forEachMember(const std::vector<std::string>& names, const Visit& visit) {
    const auto named = [&](const Member& member) { return std::count(names.begin(), names.end(), member.name) > 0; };
    for (const Member& member : patchMembers)
        if (named(member)) visit(member, true);
    for (const Member& member : cornerMembers)
        if (named(member)) visit(member, false);
}

template <class Item>
bool isAsMade(const std::vector<Item>& items, const Member& member) {
    const Item made;
    const char* bytes = reinterpret_cast<const char*>(&made) + member.offset;
    return std::all_of(items.begin(), items.end(), [&](const Item& item) {
        return std::memcmp(reinterpret_cast<const char*>(&item) + member.offset, bytes, member.size) == 0;
    });
}

// Visits the members, and the items that have them.
template <class AnyState, class Visit>
void forEachOf(AnyState& state, const std::vector<std::string>& names, const Visit& visit) {
    forEachMember(names, [&](const Member& member, bool ofPatch) {
        if (ofPatch)
            visit(member, state.patches);
        else
            visit(member, state.corners);
    });
}

Json stateToJson(const State& state, const std::vector<std::string>& names) {
    Json json = {{"patches", state.patches.size()}, {"corners", state.corners.size()}};
    forEachOf(state, names,
              [&](const Member& member, const auto& items) { json[member.name] = packed(items, member); });
    return json;
}

// Of a state that the judge made; most of its members are zero.
Json wholeStateToJson(const State& state) {
    Json json = {{"patches", state.patches.size()}, {"corners", state.corners.size()}};
    forEachOf(state, memberNames(), [&](const Member& member, const auto& items) {
        if (!isAsMade(items, member)) json[member.name] = packed(items, member);
    });
    return json;
}

State wholeStateFromJson(const Json& json) {
    State state;
    state.patches.resize(json.at("patches").get<std::size_t>());
    state.corners.resize(json.at("corners").get<std::size_t>());
    forEachOf(state, memberNames(), [&](const Member& member, auto& items) {
        if (json.contains(member.name)) unpack(json, member, items);
    });
    return state;
}

Json toJson(const Vec3f& v) { return Json::array({v.x, v.y, v.z}); }
Vec3f vectorFrom(const Json& json) {
    return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

Json vectorsToJson(const std::vector<Vec3f>& vectors) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(vectors.data());
    return Json::binary({bytes, bytes + vectors.size() * sizeof(Vec3f)});
}

std::vector<Vec3f> vectorsFrom(const Json& json) {
    const Json::binary_t& bytes = json.get_binary();
    std::vector<Vec3f> vectors(bytes.size() / sizeof(Vec3f));
    if (!vectors.empty()) std::memcpy(static_cast<void*>(vectors.data()), bytes.data(), vectors.size() * sizeof(Vec3f));
    return vectors;
}

// What extensions alone are asked for.
void addExtension(Json& json, const Step& step) {
    if (step.samples) json["samples"] = step.samples;
    if (step.seed) json["seed"] = step.seed;
    if (!step.mirror.empty()) json["mirror"] = vectorsToJson(step.mirror);
    if (step.inFloats) json["inFloats"] = true;
}

Json stepToJson(const Step& step) {
    Json json = {{"function", step.function}, {"shooter", step.shooter},   {"standIns", step.standIns},
                 {"width", step.width},       {"height", step.height},     {"hemicubeSize", step.hemicubeSize},
                 {"shots", step.shots},       {"analytic", step.analytic}, {"wanted", step.wanted}};
    json["view"] = std::vector<float>(glm::value_ptr(step.view), glm::value_ptr(step.view) + 16);
    json["unshot"] = vectorsToJson(step.unshot);
    addExtension(json, step);
    if (step.state) json["state"] = wholeStateToJson(*step.state);
    return json;
}

Step stepFromJson(const Json& json) {
    Step step;
    json.at("function").get_to(step.function);
    json.at("shooter").get_to(step.shooter);
    json.at("standIns").get_to(step.standIns);
    json.at("width").get_to(step.width);
    json.at("height").get_to(step.height);
    json.at("hemicubeSize").get_to(step.hemicubeSize);
    json.at("shots").get_to(step.shots);
    json.at("analytic").get_to(step.analytic);
    json.at("wanted").get_to(step.wanted);
    step.view = glm::make_mat4(json.at("view").get<std::vector<float>>().data());
    step.unshot = vectorsFrom(json.at("unshot"));
    step.samples = json.value("samples", 0);
    step.seed = json.value("seed", std::uint64_t{0});
    if (json.contains("mirror")) step.mirror = vectorsFrom(json.at("mirror"));
    step.inFloats = json.value("inFloats", false);
    if (json.contains("state")) step.state = wholeStateFromJson(json.at("state"));
    return step;
}

Json answerToJson(const StepAnswer& answer, const std::vector<std::string>& wanted) {
    Json calls = Json::array();
    for (const HemicubeCall& call : answer.calls)
        calls.push_back({{"reads", call.reads},
                         {"eye", toJson(call.eye)},
                         {"up", toJson(call.up)},
                         {"direction", toJson(call.direction)}});
    Json json = {{"stop", static_cast<int>(answer.stop.kind)},
                 {"text", Json::binary({answer.stop.text.begin(), answer.stop.text.end()})},
                 {"returned", answer.returned},
                 {"shots", answer.shots},
                 {"pixels", Json::binary(answer.pixels)},
                 {"calls", calls},
                 {"state", stateToJson(answer.state, wanted)}};
    if (!answer.picture.empty()) json["picture"] = vectorsToJson(answer.picture);
    return json;
}

StepAnswer answerFromJson(const Json& json, const Step& step, const State& before) {
    StepAnswer answer;
    const int kind = json.at("stop").get<int>();
    if (kind < 0 || kind > static_cast<int>(Stop::Kind::machine)) throw Error("unknown kind of stop");
    answer.stop.kind = static_cast<Stop::Kind>(kind);
    const Json::binary_t& text = json.at("text").get_binary();
    answer.stop.text.assign(text.begin(), text.end());
    json.at("returned").get_to(answer.returned);
    json.at("shots").get_to(answer.shots);
    answer.pixels = json.at("pixels").get_binary();
    if (json.contains("picture")) answer.picture = vectorsFrom(json.at("picture"));
    const std::size_t count = static_cast<std::size_t>(step.width) * static_cast<std::size_t>(step.height);
    if (answer.pixels.size() != (step.inFloats ? 0 : 3 * count) && kind == 0) throw Error("pixels: wrong size");
    if (answer.picture.size() != (step.inFloats ? count : 0) && kind == 0) throw Error("picture: wrong size");
    for (const Json& call : json.at("calls"))
        answer.calls.push_back({call.at("reads").get<bool>(), vectorFrom(call.at("eye")), vectorFrom(call.at("up")),
                                vectorFrom(call.at("direction"))});
    answer.state = before;
    if (kind == 0)
        forEachOf(answer.state, step.wanted,
                  [&](const Member& member, auto& items) { unpack(json.at("state"), member, items); });
    return answer;
}

}  // namespace

std::vector<std::string> memberNames() {
    std::vector<std::string> names;
    for (const Member& member : patchMembers) names.emplace_back(member.name);
    for (const Member& member : cornerMembers) names.emplace_back(member.name);
    return names;
}

bool draws(const Step& step) {
    return step.function == "renderPatchIDs" || step.function == "calcFF" ||
           (step.function == "solve" && !step.analytic);
}

std::string requestToCbor(std::uint64_t nonce, const std::vector<Step>& steps) {
    Json list = Json::array();
    for (const Step& step : steps) list.push_back(stepToJson(step));
    std::string bytes;
    Json::to_cbor({{"nonce", nonce}, {"steps", std::move(list)}}, bytes);
    return bytes;
}

Request requestFromCbor(std::string_view bytes) {
    try {
        const Json json = cborWithin(bytes, deepestMessage);
        Request request;
        json.at("nonce").get_to(request.nonce);
        for (const Json& step : json.at("steps")) request.steps.push_back(stepFromJson(step));
        return request;
    } catch (const Json::exception& error) {
        throw Error(std::string("request: ") + error.what());
    }
}

std::string toRecord(const StepAnswer& answer, std::uint64_t nonce, std::size_t step,
                     const std::vector<std::string>& wanted) {
    Json json = answerToJson(answer, wanted);
    json["nonce"] = nonce;
    json["step"] = step;
    std::uint64_t length = 0;
    std::string record(sizeof length, '\0');
    Json::to_cbor(json, record);
    length = record.size() - sizeof length;
    std::memcpy(record.data(), &length, sizeof length);
    return record;
}

std::vector<StepAnswer> answersFromRecords(std::string_view bytes, std::uint64_t nonce,
                                           const std::vector<Step>& steps) {
    std::vector<StepAnswer> answers;
    answers.reserve(steps.size());  // `before` points into it
    const State none;
    const State* before = &none;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::uint64_t length = 0;
        if (bytes.size() < sizeof length) break;
        std::memcpy(&length, bytes.data(), sizeof length);
        bytes.remove_prefix(sizeof length);
        if (length > bytes.size()) break;
        try {
            const Json json = cborWithin(bytes.substr(0, length), deepestMessage);
            if (json.at("nonce").get<std::uint64_t>() != nonce || json.at("step").get<std::size_t>() != i) break;
            const Step& step = steps[i];
            answers.push_back(answerFromJson(json, step, step.state ? *step.state : *before));
        } catch (const std::exception&) {
            break;  // hostile or broken: the rest cannot be trusted either
        }
        before = &answers.back().state;
        bytes.remove_prefix(length);
    }
    return answers;
}

}  // namespace radlab::grader
