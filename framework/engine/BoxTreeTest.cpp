#include "engine/BoxTree.h"

#include <doctest/doctest.h>

#include "engine/LowDiscrepancy.h"

using namespace radlab::engine;

TEST_CASE("a tree of boxes finds those that meet another, each once, and none that is empty") {
    for (const std::size_t count : {0, 1, 2, 3, 100, 1000}) {
        CAPTURE(count);
        std::vector<Box> boxes(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (i % 10 == 9) continue;
            const auto at = LowDiscrepancy(i % 50).at(i);
            boxes[i].add(Point(at[0], at[1], at[2]));
            boxes[i].add(Point(at[0], at[1], at[2]) + 0.1 * at[3]);
        }
        Box asked;
        asked.add(Point(0.2, 0.3, 0.4));
        asked.add(Point(0.5, 0.6, 0.7));
        std::vector<int> times(count);
        const BoxTree tree(boxes);
        tree.visit([&](const Box& box) { return box.meets(asked); }, [&](std::size_t i) { return ++times[i] > 0; });
        for (std::size_t i = 0; i < count; ++i) {
            CHECK(times[i] <= (i % 10 == 9 ? 0 : 1));
            if (boxes[i].meets(asked)) CHECK(times[i] == 1);
        }
    }
}
