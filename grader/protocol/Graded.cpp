#include "grader/protocol/Graded.h"

#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "grader/protocol/Cbor.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

using Json = nlohmann::json;

constexpr std::size_t deepestVerdict = 16;  // levels of its CBOR, with some to spare

Json toJson(const CheckPicture& picture) {
    Json images = Json::array();
    for (const PngImage& image : picture.images)
        images.push_back({{"title", validUtf8(image.title)},
                          {"png", Json::binary({image.png.begin(), image.png.end()})},
                          {"width", image.width},
                          {"height", image.height}});
    return {{"stage", validUtf8(picture.stage)},     {"check", validUtf8(picture.check)},
            {"caption", validUtf8(picture.caption)}, {"rms", picture.rms},
            {"tolerance", picture.tolerance},        {"images", std::move(images)}};
}

CheckPicture pictureFrom(const Json& json) {
    CheckPicture picture;
    json.at("stage").get_to(picture.stage);
    json.at("check").get_to(picture.check);
    json.at("caption").get_to(picture.caption);
    json.at("rms").get_to(picture.rms);
    json.at("tolerance").get_to(picture.tolerance);
    for (const Json& image : json.at("images")) {
        const Json::binary_t& png = image.at("png").get_binary();
        picture.images.push_back({image.at("title").get<std::string>(),
                                  {png.begin(), png.end()},
                                  image.at("width").get<int>(),
                                  image.at("height").get<int>()});
    }
    return picture;
}

}  // namespace

std::string toCbor(const Graded& graded) {
    Json pictures = Json::array();
    for (const CheckPicture& picture : graded.pictures) pictures.push_back(toJson(picture));
    std::string bytes;
    Json::to_cbor({{"result", resultToJson(graded.result)}, {"pictures", std::move(pictures)}}, bytes);
    return bytes;
}

Graded gradedFromCbor(std::string_view bytes) {
    try {
        const Json json = cborWithin(bytes, deepestVerdict);
        Graded graded;
        graded.result = resultFromJson(json.at("result"));
        for (const Json& picture : json.at("pictures")) graded.pictures.push_back(pictureFrom(picture));
        return graded;
    } catch (const Json::exception& error) {
        throw Error(std::string("graded submission: ") + error.what());
    }
}

}  // namespace radlab::grader
