#include "scene/Channels.h"

#include <doctest/doctest.h>

using namespace radlab;

namespace {

const std::vector<glm::dvec3> greys{{0.5, 0.5, 0.5}, {0.2, 0.2, 0.2}};

}  // namespace

TEST_CASE("one channel is solved where emissions are in proportion and reflectances grey") {
    const Channels channels = channelsOf({{1, 2, 3}, {0, 0, 0}}, greys);
    CHECK(channels.count() == 1);
    CHECK(channels.spread({7, 0, 0}) == glm::dvec3(7, 14, 21));
    CHECK(channelsOf({{1, 2, 3}, {2, 4, 6}}, greys).count() == 1);
}

TEST_CASE("a channel of its own is solved by itself") {
    CHECK(channelsOf({{1, 2, 3}, {1, 1, 1}}, greys).count() == 3);
    CHECK(channelsOf({{1, 2, 1}, {1, 1, 1}}, greys).like == std::array<int, 3>{0, 1, 0});
    CHECK(channelsOf({{1, 1, 1}}, {{0.5, 0.5, 0.4}}).like == std::array<int, 3>{0, 0, 2});
    CHECK(channelsOf({{1, 1, 1}}, {{0.5, 0.4, 0.4}}).like == std::array<int, 3>{0, 1, 1});
}

TEST_CASE("a light that only one of two channels has keeps them apart") {
    CHECK(channelsOf({{1, 1, 0}, {0, 1, 0}}, greys).like == std::array<int, 3>{0, 1, Channels::dark});
    CHECK(channelsOf({{1, 1, 0}, {1, 0, 0}}, greys).like == std::array<int, 3>{0, 1, Channels::dark});
}

TEST_CASE("a channel without emission is dark, whatever reflects it") {
    const Channels channels = channelsOf({{0, 3, 0}, {0, 0, 0}}, {{1, 0.5, 0}, {0, 0.1, 1}});
    CHECK(channels.count() == 1);
    CHECK(channels.solved(1));
    CHECK(channels.spread({9, 4, 9}) == glm::dvec3(0, 4, 0));
    CHECK(channelsOf(greys, greys).count() == 1);
    CHECK(channelsOf({{0, 0, 0}}, {{0.1, 0.5, 0.9}}).count() == 0);
    CHECK(channelsOf({}, {}).count() == 0);
}
