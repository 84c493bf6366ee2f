#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "course/Extensions.h"

namespace {

struct Dark : PictureView {
    Vec3f radiance(float, float) const override { return Vec3f(0.0f); }
    Vec3f display(const Vec3f& radiance) const override { return radiance; }
};

struct Nothing : MirrorPass {
    bool showsMirror(int, int) const override { return true; }
    radlab::Image draw(const glm::mat4&, const glm::vec4&, bool) const override { return radlab::Image(1, 1); }
};

}  // namespace

TEST_CASE("every stub of the extensions says that it is not written yet, by its own name") {
    const RayCaster scene({}, {});
    RandomNumbers random(1);
    radlab::Image picture(1, 1);
    const std::vector<std::pair<std::string, std::function<void()>>> stubs = {
        {"hemisphereFF", [&] { hemisphereFF(scene, 1, random); }},
        {"antialias", [&] { antialias(Dark(), 1, picture); }},
        {"mirrorScene", [&] { mirrorScene(Nothing(), Vec3f(0.0f), Vec3f(1.0f), Vec3f(1.0f), picture); }}};
    for (const auto& [name, stub] : stubs) {
        const std::string function = name;
        CAPTURE(function);
        std::string thrown = "nothing";
        try {
            stub();
        } catch (const NotImplemented& notWritten) {
            thrown = notWritten.function();
        }
        CHECK(thrown == name);
    }
}
