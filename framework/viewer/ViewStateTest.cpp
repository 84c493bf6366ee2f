#include "viewer/ViewState.h"

#include <doctest/doctest.h>

#include "base/Error.h"

using namespace radlab;

TEST_CASE("a state written as JSON is read back to the last bit") {
    ViewState state;
    state.patchSize = 0.1f;
    state.lightSize = 1.0f / 3.0f;
    state.hemicubeSize = 64;
    state.method = FormFactorMethod::hemicube;
    state.mode = Mode::unshot;
    state.curve = ToneCurve::filmic;
    state.autoExposure = false;
    state.exposure = 0.7f;
    state.shotsPerFrame = 3;
    state.panel = false;
    state.camera.orbit(0.7f, 0.3f);
    const ViewState back = viewStateFrom(toJson(state));
    CHECK(toJson(back) == toJson(state));
    CHECK(back.lightSize == state.lightSize);
    CHECK(back.camera.position == state.camera.position);
    CHECK(back.camera.up == state.camera.up);
    CHECK(back.mode == Mode::unshot);
}

TEST_CASE("a state that is cut off, unknown or out of range is refused") {
    ViewState state;
    CHECK_THROWS_AS(viewStateFrom(toJson(state)), Error);  // no patch size
    state.patchSize = state.lightSize = 1.0f;
    const std::string good = toJson(state);
    CHECK_NOTHROW(viewStateFrom(good));
    CHECK_THROWS_AS(viewStateFrom(good.substr(0, good.size() / 2)), Error);
    CHECK_THROWS_AS(viewStateFrom("[]"), Error);
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    CHECK_THROWS_AS(viewStateFrom(with("\"smooth\"", "\"smoth\"")), Error);
    CHECK_THROWS_AS(viewStateFrom(with("\"hemicube_size\": 256", "\"hemicube_size\": 255")), Error);
    CHECK_THROWS_AS(viewStateFrom(with("\"exposure\": 1.0", "\"exposure\": -1")), Error);
    CHECK_THROWS_AS(viewStateFrom(with("\"distance\": 10.0", "\"distance\": 0")), Error);
}
