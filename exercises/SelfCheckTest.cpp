#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "course/ProgRef.h"

TEST_CASE("every stub of the exercise says that it is not written yet, by its own name") {
    const std::vector<std::pair<std::string, std::function<void()>>> stubs = {
        {"maxenergy_patch", [] { maxenergy_patch(); }},
        {"calcAnalyticalFF", [] { calcAnalyticalFF(); }},
        {"distributeEnergy", [] { distributeEnergy(nullptr); }},
        {"colorReconstruction", [] { colorReconstruction(); }},
        {"renderPatchIDs", [] { renderPatchIDs(); }},
        {"calcFF", [] { calcFF(nullptr); }}};
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
