#include "grader/intake/UnpackMessage.h"

#include <algorithm>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/protocol/Cbor.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

constexpr std::size_t deepest = 4;         // levels of the answer's CBOR
constexpr std::size_t longestText = 2000;  // bytes of a remark, and of a path
constexpr std::size_t mostOthers = 20;

// Text may be any bytes, which JSON's strings are not.
Json binary(const std::string& bytes) { return Json::binary({bytes.begin(), bytes.end()}); }

std::string bytesFrom(const Json& json, std::size_t most) {
    const Json::binary_t& bytes = json.get_binary();
    if (bytes.size() > most)
        throw Error("found " + std::to_string(bytes.size()) + " bytes, expected at most " + std::to_string(most));
    return {bytes.begin(), bytes.end()};
}

const Json& arrayOf(const Json& json, std::size_t most) {
    if (!json.is_array() || json.size() > most)
        throw Error("found " + std::to_string(json.size()) + " items, expected at most " + std::to_string(most));
    return json;
}

Json toJson(const Remark& remark) { return {{"refuses", remark.refuses}, {"text", binary(remark.text)}}; }

void readFiles(const Json& json, const IntakeRules& rules, Gathered& gathered) {
    for (const Json& file : arrayOf(json, rules.files.size())) {
        const auto name = file.at("name").get<std::string>();
        if (std::count(rules.files.begin(), rules.files.end(), name) == 0) throw Error("a file that nobody asked for");
        gathered.files[name] = {bytesFrom(file.at("path"), longestText),
                                bytesFrom(file.at("contents"), rules.mostBytes)};
    }
}

}  // namespace

std::string toCbor(const Gathered& gathered) {
    Json files = Json::array(), others = Json::array(), remarks = Json::array();
    for (const auto& [name, file] : gathered.files)
        files.push_back({{"name", name}, {"path", binary(file.path)}, {"contents", binary(file.contents)}});
    for (const std::string& other : gathered.others) others.push_back(binary(shownName(other)));
    for (const Remark& remark : gathered.remarks.told()) remarks.push_back(toJson(remark));
    std::string bytes;
    Json::to_cbor({{"files", files},
                   {"others", others},
                   {"moreOthers", gathered.moreOthers},
                   {"remarks", remarks},
                   {"untold", gathered.remarks.untold()}},
                  bytes);
    return bytes;
}

Gathered gatheredFromCbor(std::string_view bytes, const IntakeRules& rules) {
    try {
        const Json json = cborWithin(bytes, deepest);
        Gathered gathered(rules);
        readFiles(json.at("files"), rules, gathered);
        for (const Json& other : arrayOf(json.at("others"), mostOthers))
            gathered.others.push_back(bytesFrom(other, longestText));
        json.at("moreOthers").get_to(gathered.moreOthers);
        for (const Json& remark : arrayOf(json.at("remarks"), rules.mostRemarks))
            gathered.remarks.add(
                {visibleLine(bytesFrom(remark.at("text"), longestText)), remark.at("refuses").get<bool>()});
        gathered.remarks.addUntold(json.at("untold").get<std::uint32_t>());
        return gathered;
    } catch (const Json::exception& error) {
        throw Error(error.what());
    }
}

std::string rulesToText(const IntakeRules& rules) {
    const Json json = {{"files", rules.files},
                       {"mostBytes", rules.mostBytes},
                       {"mostArchive", rules.mostArchive},
                       {"mostUnpacked", rules.mostUnpacked},
                       {"mostRatio", rules.mostRatio},
                       {"ratioCountsFrom", rules.ratioCountsFrom},
                       {"mostEntries", rules.mostEntries},
                       {"deepest", rules.deepest},
                       {"mostRemarks", rules.mostRemarks}};
    return json.dump();
}

IntakeRules rulesFromText(const std::string& text) {
    try {
        const Json json = Json::parse(text);
        IntakeRules rules;
        json.at("files").get_to(rules.files);
        json.at("mostBytes").get_to(rules.mostBytes);
        json.at("mostArchive").get_to(rules.mostArchive);
        json.at("mostUnpacked").get_to(rules.mostUnpacked);
        json.at("mostRatio").get_to(rules.mostRatio);
        json.at("ratioCountsFrom").get_to(rules.ratioCountsFrom);
        json.at("mostEntries").get_to(rules.mostEntries);
        json.at("deepest").get_to(rules.deepest);
        json.at("mostRemarks").get_to(rules.mostRemarks);
        return rules;
    } catch (const Json::exception& error) {
        throw Error(std::string("rules: ") + error.what());
    }
}

}  // namespace radlab::grader
