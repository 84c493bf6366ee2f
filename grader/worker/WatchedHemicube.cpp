#include "grader/worker/WatchedHemicube.h"

#include "grader/worker/DrawIds.h"

namespace radlab::grader {

namespace {

// A submission that never stops calling must not fill the memory with notes.
constexpr std::size_t mostNotes = 64;

}  // namespace

void WatchedHemicube::renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                                  const std::function<void()>& draw) {
    if (calls.size() < mostNotes) calls.push_back({false, eye, up, direction});
    Hemicube::renderScene(eye, up, direction, drawsItself ? std::function<void()>(drawIds) : draw);
}

void WatchedHemicube::readIndexBuffer() {
    if (calls.size() < mostNotes) calls.push_back({true, Vec3f(0.0f), Vec3f(0.0f), Vec3f(0.0f)});
    Hemicube::readIndexBuffer();
}

}  // namespace radlab::grader
