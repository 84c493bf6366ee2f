#include "viewer/Simulation.h"

#include <doctest/doctest.h>

#include "gl/Context.h"
#include "scene/X3dReader.h"
#include "viewer/SceneDrawing.h"

using namespace radlab;
using doctest::Approx;

namespace {

struct Room {
    explicit Room(const std::string& name) : context(GlContext::offscreen()), simulation(scene(name), running) {
        state.patchSize = state.lightSize = patchSizeFor(simulation.scene(), 300.0);
        state.hemicubeSize = 64;
        state.camera = orbitFrom(simulation.scene().cameras.front(), simulation.scene().vertices);
    }
    static Scene scene(const std::string& name) {
        return readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + name + ".x3d");
    }
    void begin(const CourseFunctions& functions) {
        simulation.setFunctions(functions);
        simulation.cut(state);
    }

    std::unique_ptr<GlContext> context;
    RunningNow running;
    Simulation simulation;
    ViewState state;
};

}  // namespace

TEST_CASE("shots stop at their number, are recorded one by one, and unshot power falls") {
    Room room("cornell_2");
    room.begin(linkedFunctions());
    CHECK(room.simulation.method() == FormFactorMethod::hemicube);
    CHECK(room.simulation.shoot(7, 1e9) == 7);
    REQUIRE(room.simulation.history().size() == 7);
    CHECK(room.simulation.history().back().unshotShare < room.simulation.history().front().unshotShare);
    CHECK(room.simulation.hasColors());
    CHECK(room.simulation.lastShooter().has_value());
    CHECK(room.simulation.shoot(1000, 0.0) == 1);  // no time left: one shot all the same
}

TEST_CASE("a long shot is interrupted between faces, the patches then being as the last whole shot left them") {
    Room room("cornell_2");
    room.begin(linkedFunctions());
    const std::vector<MyPolygon>& patches = room.simulation.mesh().patches;
    const auto row = [&] {
        std::vector<float> formFactors;
        for (const MyPolygon& patch : patches) formFactors.push_back(patch.formF);
        return formFactors;
    };
    room.simulation.shoot(1, 1e9);
    const std::vector<float> first = row();
    int interludes = 0;
    room.simulation.setInterlude(0.0, [&] {
        ++interludes;
        CHECK(row() == first);
        CHECK(room.running.running() == Running::none);
        CHECK(room.simulation.progress().shots == 1);
    });
    CHECK(room.simulation.shoot(1, 1e9) == 1);
    CHECK(interludes == 7);  // five faces, before and after they are read
    CHECK(row() != first);
    CHECK(room.simulation.progress().shots == 2);
    room.simulation.setInterlude(0.0, [&] { FAIL("a look is no shot"); });
    CHECK(room.simulation.lookFrom(5));
}

TEST_CASE("a shot is the same with and without frames drawn in its middle") {
    std::vector<Vec3f> radiosities[2];
    for (int drawn = 0; drawn < 2; ++drawn) {
        Room room("cornell_2");
        room.begin(linkedFunctions());
        SceneDrawing drawing;
        drawing.rebuild();
        if (drawn)
            room.simulation.setInterlude(0.0,
                                         [&] { drawnPicture(drawing, room.simulation, room.state, {}, 40, 40, {}); });
        room.simulation.shoot(3, 1e9);
        for (const MyPolygon& patch : room.simulation.mesh().patches) radiosities[drawn].push_back(patch.rad);
        CHECK(drawing.glErrors() == 0);
    }
    CHECK(radiosities[0] == radiosities[1]);
}

TEST_CASE("the time of what is interrupted stands still") {
    RunningNow now;
    RunningTime time;
    const RunningMark mark(now, Running::calcFF);
    time.look(now, 1.0);
    {
        const RunningPause pause(now);
        CHECK(now.running() == Running::none);
        const RunningMark drawing(now, Running::renderPatchIDs);
        time.look(now, 2.0);
        time.look(now, 5.0);
        CHECK(time.longerThan(2.5) == Running::renderPatchIDs);
        CHECK(time.longerThan(3.5) == Running::none);
    }
    CHECK(now.running() == Running::calcFF);
    CHECK(time.longerThan(0.5) == Running::renderPatchIDs);
    time.look(now, 6.0);
    CHECK(time.longerThan(0.5) == Running::calcFF);
    CHECK(time.longerThan(1.5) == Running::none);
}

TEST_CASE("who calls another again and again has been running all the time, and each call for its own") {
    RunningNow now;
    RunningTime time;
    const RunningMark mark(now, Running::calcFF);
    for (int i = 0; i < 10; ++i) {
        const RunningMark drawing(now, Running::renderPatchIDs);
        time.look(now, i);
        time.look(now, i + 0.5);
    }
    CHECK(time.longerThan(0.4) == Running::renderPatchIDs);
    CHECK(time.longerThan(5.0) == Running::calcFF);
}

TEST_CASE("the innermost of many calls is told as far as they are told apart") {
    RunningNow now;
    std::function<void(int)> call = [&](int left) {
        const RunningMark mark(now, left > 12 ? Running::calcFF : Running::renderPatchIDs);
        if (left) return call(left - 1);
        CHECK(now.running() == Running::renderPatchIDs);
        RunningTime time;
        time.look(now, 0.0);
        time.look(now, 1.0);
        CHECK(time.longerThan(0.5) == Running::renderPatchIDs);
    };
    call(15);
    CHECK(now.running() == Running::none);
}

TEST_CASE("a stub is named with its stage, and the scene stays as it stands") {
    Room room("cornell_2");
    CourseFunctions functions = linkedFunctions();
    functions.calcFF = [](Hemicube*) -> MyPolygon* { throw NotImplemented("calcFF"); };
    room.begin(functions);
    CHECK(room.simulation.shoot(5, 1e9) == 0);
    REQUIRE(room.simulation.problem());
    CHECK(room.simulation.problem()->notWritten);
    CHECK(room.simulation.problem()->function == "calcFF");
    CHECK(room.simulation.problem()->text.find("stage 6") != std::string::npos);
    CHECK(room.running.running() == Running::none);
    CHECK(room.simulation.progress().unshotShare == 1.0);
}

TEST_CASE("what a function throws or returns wrongly is told under its name") {
    Room room("cornell_2");
    CourseFunctions functions = linkedFunctions();
    functions.distributeEnergy = [](MyPolygon*) -> bool { throw std::runtime_error("out of light"); };
    room.begin(functions);
    room.simulation.shoot(1, 1e9);
    REQUIRE(room.simulation.problem());
    CHECK(room.simulation.problem()->function == "distributeEnergy");
    static MyPolygon stranger;
    functions.distributeEnergy = linkedFunctions().distributeEnergy;
    functions.maxenergyPatch = [] { return &stranger; };
    room.begin(functions);
    room.simulation.shoot(1, 1e9);
    REQUIRE(room.simulation.problem());
    CHECK(room.simulation.problem()->function == "maxenergy_patch");
}

TEST_CASE("in a closed room a patch's row sums to 1, and looking changes nothing of the solution") {
    Room room("l_room");
    room.begin(linkedFunctions());
    room.simulation.shoot(3, 1e9);
    const Vec3f before = room.simulation.mesh().patches[5].rad, unshot = room.simulation.mesh().patches[5].unshot_rad;
    const auto view = room.simulation.lookFrom(5);
    REQUIRE(view);
    CHECK(view->sum == Approx(1.0).epsilon(1e-3));
    CHECK(view->formFactors.size() == room.simulation.mesh().patches.size());
    CHECK(view->ids.width() == 128);
    CHECK(view->weights.height() == 128);
    CHECK(room.simulation.mesh().patches[5].rad == before);
    CHECK(room.simulation.mesh().patches[5].unshot_rad == unshot);
    CHECK(room.simulation.shoot(1, 1e9) == 1);
}

TEST_CASE("a size that means too many patches is refused, and all stays as it was") {
    Room room("cornell_2");
    room.begin(linkedFunctions());
    const std::size_t before = room.simulation.mesh().patches.size();
    ViewState wanted = room.state;
    wanted.patchSize = 1e-3f;
    CHECK_THROWS_AS(room.simulation.cut(wanted), Error);
    CHECK(room.simulation.mesh().patches.size() == before);
}

TEST_CASE("picking finds the patch whose ID is drawn there, and nothing in the background") {
    Room room("cornell_2");
    room.begin(linkedFunctions());
    SceneDrawing drawing;
    drawing.rebuild();
    const Place place{0, 0, 60, 60};
    View view;
    view.camera = room.state.camera.camera();
    view.width = view.height = 60;
    view.samples = 1;
    const std::vector<std::uint32_t> ids = readIds(view, linkedFunctions().renderPatchIDs);
    const auto picked = drawing.pick(room.simulation, room.state, place, 30, 30);
    REQUIRE(picked);
    CHECK(*picked + 1 == ids[30 * 60 + 30]);
    CHECK(!drawing.pick(room.simulation, room.state, place, -1, 5));
    room.state.camera.orbit(3.1f, 0.0f);
    room.state.camera.frame({0, 0, 0}, 1e5f);
    CHECK(!drawing.pick(room.simulation, room.state, place, 0, 0));
}

TEST_CASE("a picture from vertex arrays is the picture of drawRadiance, tone mapped") {
    Room room("cornell_2");
    room.begin(linkedFunctions());
    room.simulation.shoot(20, 1e9);
    room.state.mode = Mode::flat;
    room.state.autoExposure = false;
    SceneDrawing drawing;
    drawing.rebuild();
    const Image shown = drawnPicture(drawing, room.simulation, room.state, {}, 80, 80, {});
    View view;
    view.camera = room.state.camera.camera();
    view.width = view.height = 80;
    view.samples = 1;
    CHECK(rmsDifference(shown, toneMap(drawRadiance(view, Shading::flat), 1.0f)) < 0.004);
    CHECK(drawing.glErrors() == 0);
}

TEST_CASE("unshot power is black four powers of ten below the largest") {
    CHECK(unshotColor(0.0, 1.0) == unshotColor(1e-4, 1.0));
    CHECK(unshotColor(5.0, 5.0) != unshotColor(0.5, 5.0));
    CHECK(unshotColor(1.0, 0.0) == unshotColor(0.0, 1.0));
}
