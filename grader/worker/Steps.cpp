#include "grader/worker/Steps.h"

#include <glm/gtc/type_ptr.hpp>

#include "base/Error.h"
#include "course/Extensions.h"
#include "display/RayMirrorPass.h"
#include "display/RayView.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/SavedState.h"
#include "solver/FormFactors.h"
#include "solver/Progressive.h"

namespace radlab::grader {

namespace {

constexpr Vec3f stale(0.25f);  // what pictures hold before they are made

}  // namespace

StepAnswer Steps::perform(Step& step) {
    StepAnswer answer;
    try {
        prepare(step);
    } catch (const std::exception& fault) {
        answer.stop = {Stop::Kind::machine, fault.what()};
        return answer;
    }
    try {
        call(step, answer);
    } catch (const NotImplemented& stub) {
        answer.stop = {Stop::Kind::notImplemented, stub.function()};
    } catch (const Error& error) {
        answer.stop = {Stop::Kind::error, error.what()};
    } catch (const std::exception& exception) {
        answer.stop = {Stop::Kind::exception, exception.what()};
    } catch (...) {
        answer.stop = {Stop::Kind::exception, "something that is no std::exception"};
    }
    if (hemicube) answer.calls = hemicube->calls;
    answer.state.patches = std::move(mesh.patches);
    answer.state.corners = std::move(mesh.corners);
    return answer;
}

void Steps::takeBack(StepAnswer& answer) {
    mesh.patches = std::move(answer.state.patches);
    mesh.corners = std::move(answer.state.corners);
}

void Steps::prepare(Step& step) {
    if (step.state) {
        mesh.patches = std::move(step.state->patches);
        mesh.corners = std::move(step.state->corners);
    }
    for (std::size_t i = 0; i < step.unshot.size() && i < mesh.patches.size(); ++i)
        mesh.patches[i].unshot_rad = step.unshot[i];
    mesh.publish();
    if (step.standIns)
        submission.standIn(patchAt(step.shooter));
    else
        submission.standAside();
    if (draws(step)) startOpenGl();
    if (draws(step) && step.function != "renderPatchIDs") prepareHemicube(step);
    if (hemicube) hemicube->calls.clear();
}

void Steps::call(const Step& step, StepAnswer& answer) {
    const std::string& name = step.function;
    if (name.empty()) return;
    if (name != "solve" && !submission.has(name)) {
        answer.stop = {Stop::Kind::missing, name};
        return;
    }
    if (name == "maxenergy_patch") answer.returned = indexOf(submission.maxenergyPatch());
    if (name == "calcAnalyticalFF") answer.returned = indexOf(submission.calcAnalyticalFF());
    if (name == "distributeEnergy") answer.returned = submission.distributeEnergy(patchAt(step.shooter)) ? 1 : 0;
    if (name == "colorReconstruction") submission.colorReconstruction();
    if (name == "renderPatchIDs") draw(step, answer);
    if (name == "calcFF") answer.returned = indexOf(submission.calcFF(hemicube.get()));
    if (name == "hemisphereFF") answer.returned = indexOf(shootRays(step));
    if (name == "antialias") answer.picture = sampled(step);
    if (name == "mirrorScene") answer.picture = mirrored(step);
    if (name == "solve") solve(step, answer);
}

std::vector<Vec3f> Steps::sampled(const Step& step) {
    const RayCaster scene(polygons, vertices);
    Image picture(step.width, step.height, stale);
    submission.antialias(RayView(scene, step.view, step.width, step.height, 1.0f), step.samples, picture);
    return picture.data();
}

std::vector<Vec3f> Steps::mirrored(const Step& step) {
    const MyPolygon* mirror = patchAt(step.shooter);
    const RayMirrorPass pass(
        polygons, vertices, [=](const MyPolygon* patch) { return patch == mirror; }, step.view, step.width,
        step.height);
    Image picture = pass.first();
    submission.mirrorScene(pass, step.mirror.at(0), step.mirror.at(1), step.mirror.at(2), picture);
    return picture.data();
}

const MyPolygon* Steps::shootRays(const Step& step) {
    RandomNumbers random(step.seed);
    return submission.hemisphereFF(RayCaster(polygons, vertices), step.samples, random);
}

void Steps::draw(const Step& step, StepAnswer& answer) {
    const Framebuffer picture(step.width, step.height, Framebuffer::Color::bytes);
    SavedState saved;
    picture.bind();
    setIdPassState();
    glViewport(0, 0, step.width, step.height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(step.view));
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    submission.renderPatchIDs();
    saved.checkBalance();
    glFinish();
    picture.bind();
    answer.pixels.resize(3 * static_cast<std::size_t>(step.width) * static_cast<std::size_t>(step.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, step.width, step.height, GL_RGB, GL_UNSIGNED_BYTE, answer.pixels.data());
}

void Steps::solve(const Step& step, StepAnswer& answer) {
    submission.standAside();
    Progressive::FormFactors formFactors = [] { return ::calcAnalyticalFF(); };
    if (!step.analytic) formFactors = [this] { return ::calcFF(hemicube.get()); };
    Progressive solver(mesh, formFactors);
    answer.shots = solver.run({step.shots, 0.0}).shots;
}

void Steps::startOpenGl() {
    if (!context) context = GlContext::offscreen();
}

void Steps::prepareHemicube(const Step& step) {
    if (!hemicube || hemicube->rendersize != 2 * step.hemicubeSize)
        hemicube = std::make_unique<WatchedHemicube>(step.hemicubeSize);
    hemicube->drawsItself = step.standIns;
}

int Steps::indexOf(const MyPolygon* patch) const {
    if (!patch) return -1;
    for (std::size_t i = 0; i < mesh.patches.size(); ++i)
        if (patch == &mesh.patches[i]) return static_cast<int>(i);
    return -2;
}

MyPolygon* Steps::patchAt(int index) {
    const bool exists = index >= 0 && static_cast<std::size_t>(index) < mesh.patches.size();
    return exists ? &mesh.patches[static_cast<std::size_t>(index)] : nullptr;
}

}  // namespace radlab::grader
