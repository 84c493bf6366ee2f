#include "grader/protocol/Message.h"

#include <cmath>
#include <cstring>

#include <doctest/doctest.h>

#include "base/Error.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Request request() {
    Request made;
    made.nonce = 0xfedcba9876543210;
    State state;
    state.patches.resize(3);
    state.corners.resize(2);
    state.patches[1].vertex[2] = 7;
    state.patches[2].formF = 0.25f;
    state.corners[1].position = Vec3f(1, 2, 3);
    Step first;
    first.function = "calcFF";
    first.state = state;
    first.hemicubeSize = 32;
    first.wanted = {"patch.formF", "corner.colorcount"};
    Step second;
    second.function = "distributeEnergy";
    second.samples = 65536;
    second.seed = 0x123456789abcdef0;
    second.unshot = {Vec3f(1), Vec3f(2), Vec3f(3)};
    second.shooter = 2;
    second.wanted = {"patch.rad"};
    made.steps = {first, second};
    return made;
}

std::string answered(const Request& to) {
    StepAnswer answer;
    answer.returned = 1;
    answer.calls = {{false, Vec3f(1), Vec3f(2), Vec3f(3)}, {true, {}, {}, {}}};
    answer.state = *to.steps[0].state;
    answer.state.patches[0].formF = 0.5f;
    answer.state.patches[0].area = 99.0f;  // not wanted
    const std::string first = toRecord(answer, to.nonce, 0, to.steps[0].wanted);
    answer.calls.clear();
    answer.stop = {Stop::Kind::exception, "odd \xff bytes"};
    return first + toRecord(answer, to.nonce, 1, to.steps[1].wanted);
}

}  // namespace

TEST_CASE("a request arrives as it was sent") {
    const Request sent = request(), got = requestFromCbor(requestToCbor(sent.nonce, sent.steps));
    REQUIRE(got.steps.size() == 2);
    CHECK(got.nonce == sent.nonce);
    CHECK(got.steps[0].function == "calcFF");
    CHECK(got.steps[0].samples == 0);
    CHECK(got.steps[1].samples == 65536);
    CHECK(got.steps[1].seed == 0x123456789abcdef0);
    CHECK(got.steps[0].state->patches[1].vertex[2] == 7);
    CHECK(got.steps[0].state->patches[2].formF == 0.25f);
    CHECK(got.steps[0].state->corners[1].position == Vec3f(1, 2, 3));
    CHECK(got.steps[0].hemicubeSize == 32);
    CHECK_FALSE(got.steps[1].state);
    CHECK(got.steps[1].unshot == sent.steps[1].unshot);
    CHECK(got.steps[1].shooter == 2);
    CHECK(got.steps[0].state->patches[0].vertex[1] == -1);
    CHECK_THROWS_AS(requestFromCbor("nonsense"), Error);
}

TEST_CASE("members of a request's state that nobody set do not travel") {
    Step step;
    step.state = State{};
    step.state->patches.resize(10000);
    const std::size_t bare = requestToCbor(1, {step}).size();
    CHECK(bare < 1000);
    step.state->patches[9999].area = -0.0f;
    const std::string bytes = requestToCbor(1, {step});
    CHECK(bytes.size() > bare + 40000);
    CHECK(bytes.size() < bare + 40100);
    CHECK(std::signbit(requestFromCbor(bytes).steps[0].state->patches[9999].area));
}

TEST_CASE("answers bring the members that were wanted, and nothing else") {
    const Request asked = request();
    const std::vector<StepAnswer> answers = answersFromRecords(answered(asked), asked.nonce, asked.steps);
    REQUIRE(answers.size() == 2);
    CHECK(answers[0].returned == 1);
    CHECK(answers[0].state.patches[0].formF == 0.5f);
    CHECK(answers[0].state.patches[0].area == 0.0f);
    CHECK(answers[0].calls.size() == 2);
    CHECK(answers[0].calls[0].up == Vec3f(2));
    CHECK(answers[0].calls[1].reads);
    CHECK(answers[1].stop.kind == Stop::Kind::exception);
    CHECK(answers[1].stop.text == "odd \xff bytes");
}

TEST_CASE("answers that are cut off, changed, of another request or out of order are not taken") {
    const Request asked = request();
    const std::string whole = answered(asked);
    for (std::size_t length = 0; length < whole.size(); ++length)
        CHECK(answersFromRecords(whole.substr(0, length), asked.nonce, asked.steps).size() < 2);
    CHECK(answersFromRecords(whole, 1, asked.steps).empty());
    const StepAnswer answer;
    CHECK(answersFromRecords(toRecord(answer, asked.nonce, 1, {}), asked.nonce, asked.steps).empty());
    CHECK(answersFromRecords(toRecord(answer, asked.nonce, 0, asked.steps[0].wanted), asked.nonce, asked.steps)
              .empty());  // too few patches
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ 0x55);
        CHECK_NOTHROW(answersFromRecords(changed, asked.nonce, asked.steps));
    }
}

TEST_CASE("a record of nothing but levels ends the list, and such a request is an error") {
    const Request asked = request();
    const std::uint64_t length = 1'000'000;
    std::string record(sizeof length + length, '\x81');
    std::memcpy(record.data(), &length, sizeof length);
    CHECK(answersFromRecords(record, asked.nonce, asked.steps).empty());
    CHECK_THROWS_AS(requestFromCbor(std::string(1'000'000, '\x81')), Error);
}
