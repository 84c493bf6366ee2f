#include <cmath>

#include "grader/stages/HemicubeFFWays.h"

namespace radlab::grader {

namespace {

// Which buffer is read --------------------------------------------------------------------------

std::vector<Mistake> buffers(const Ways& ways) {
    return {
        {"read-back-missing",
         "The index buffer is never read back. renderScene draws in OpenGL's memory; getIndex looks into a copy, which "
         "readIndexBuffer makes.",
         "How do the pixels get from OpenGL to getIndex?", ways.with([](ShotWay& way) {
             way.fits = [](const HemicubeUse& use) { return use.rendered && !use.read; };
             way.collect = nothing;
         })},
        {"render-missing", "The index buffer is read, but nothing is ever rendered into it.",
         "Who draws the patch IDs, and when?", ways.with([](ShotWay& way) {
             way.fits = [](const HemicubeUse& use) { return use.read && !use.rendered; };
             way.collect = nothing;
         })},
        {"read-before-render",
         "The index buffer is read before the scene is rendered: the IDs are those of the shot before, and at first "
         "there "
         "are none.",
         "In which order do things happen: rendering, reading back, looking up?", ways.with([](ShotWay& way) {
             way.fits = [](const HemicubeUse& use) { return use.readTooEarly; };
             way.readsBefore = true;
         })},
    };
}

// Where the hemicube stands ---------------------------------------------------------------------

bool near(const Vec3f& a, const Vec3f& b, double distance) {
    return glm::distance(glm::dvec3(a), glm::dvec3(b)) <= distance;
}

// The submission's vector if it is one of those that a mistake can lead to; where there is no submission, the first.
std::optional<Vec3f> oneOf(const std::vector<Vec3f>& wanted, const std::optional<Vec3f>& used, double distance) {
    if (!used) return wanted[0];
    for (const Vec3f& v : wanted)
        if (near(v, *used, distance)) return *used;
    return std::nullopt;
}

// A camera at one of some places, looking one of some ways; the up vector is free where it can be.
std::optional<Camera> cameraAt(const Situation& at, const std::vector<Vec3f>& eyes,
                               const std::vector<Vec3f>& directions, double edge) {
    const std::optional<Camera> used = useOf(at.answer).camera;
    const auto eye = oneOf(eyes, used ? std::optional(used->eye) : std::nullopt, 1e-3 * edge);
    const auto direction =
        oneOf(directions, used ? std::optional(used->direction) : std::nullopt, 1e-3 * length(directions[0]));
    if (!eye || !direction || length(*direction) == 0.0f) return std::nullopt;
    return Camera{*eye, used ? used->up : perpendicular(*direction), *direction};
}

double edgeOf(const MyPolygon& patch) { return std::sqrt(static_cast<double>(patch.area)); }

std::vector<Vec3f> cornersOf(const Situation& at, const MyPolygon& patch) {
    std::vector<Vec3f> corners;
    for (int i = 0; i < patch.vertices; ++i)
        corners.push_back(at.before.corners[static_cast<std::size_t>(patch.vertex[i])].position);
    return corners;
}

std::vector<Mistake> places(const Ways& ways) {
    const std::string middle = "The form factor is taken from the patch's centre.";
    return {
        {"eye-at-vertex", "The hemicube stands at a corner of the shooter. " + middle,
         "Which point of the patch is in its middle?", ways.camera([](const Situation& at, const MyPolygon& from) {
             return cameraAt(at, cornersOf(at, from), {from.normal}, edgeOf(from));
         })},
        {"eye-at-origin", "The hemicube stands at the origin of the scene, not on the shooter. " + middle,
         "Where does the light of this shot come from?", ways.camera([](const Situation& at, const MyPolygon& from) {
             return cameraAt(at, {Vec3f(0.0f)}, {from.normal}, edgeOf(from));
         })},
    };
}

// Which way it looks ----------------------------------------------------------------------------

Computation looks(const Ways& ways, const std::function<Vec3f(const MyPolygon& from)>& direction) {
    return ways.camera([direction](const Situation& at, const MyPolygon& from) {
        return cameraAt(at, {from.center}, {direction(from)}, edgeOf(from));
    });
}

// Along some line in the plane of the shooter.
std::optional<Camera> inPlane(const Situation& at, const MyPolygon& from) {
    const std::optional<Camera> used = useOf(at.answer).camera;
    const Vec3f direction = used ? used->direction : perpendicular(from.normal);
    if (std::abs(dot(direction, from.normal)) > 1e-3f * length(direction)) return std::nullopt;
    return cameraAt(at, {from.center}, {direction}, edgeOf(from));
}

Vec3f axis(int k, float sign) {
    Vec3f v(0.0f);
    v[k] = sign;
    return v;
}

std::optional<Camera> alongAxis(const Situation& at, const MyPolygon& from) {
    std::vector<Vec3f> all;
    for (const float sign : {-1.0f, 1.0f})
        for (const int k : {2, 1, 0}) all.push_back(axis(k, sign));
    return cameraAt(at, {from.center}, all, edgeOf(from));
}

std::vector<Mistake> directions(const Ways& ways) {
    const std::string direction =
        "renderScene takes eye, up and direction, in this order; the direction is the patch's normal.";
    return {
        {"looking-backwards", "The hemicube looks against the normal: into the wall, or at what lies behind it.",
         "To which side of a patch does its normal point, and to which one does it shine?",
         looks(ways, [](const MyPolygon& from) { return -from.normal; })},
        {"target-for-direction",
         "A point in front of the patch is given for the direction, as gluLookAt takes one. " + direction,
         "Is centre plus normal a direction?",
         looks(ways, [](const MyPolygon& from) { return from.center + from.normal; })},
        {"position-as-direction", "The patch's centre is given for the direction: that is a place. " + direction,
         "Which member of a patch says which way it looks?",
         looks(ways, [](const MyPolygon& from) { return from.center; })},
        {"looking-along-the-patch",
         "The hemicube looks along the patch, not away from it: half of it sees what lies behind. " + direction,
         "Which of the three vectors is which?", ways.camera(inPlane)},
        {"direction-fixed", "The direction is the same for every shooter. " + direction,
         "Which way do the patches of another wall look?", ways.camera(alongAxis)},
    };
}

// Which way is up -------------------------------------------------------------------------------

Computation refused(const Ways& ways, const std::function<bool(const MyPolygon& from)>& when, const std::string& text) {
    return ways.with([&](ShotWay& way) {
        way.stop = [=](const MyPolygon& from) { return when(from) ? Stop{Stop::Kind::error, text} : Stop{}; };
    });
}

std::vector<Mistake> upVectors(const Ways& ways) {
    std::vector<Mistake> all;
    const std::string lies = "The up vector must lie in the patch: what leads from its centre to a corner always does.";
    for (const int k : {1, 2, 0})
        all.push_back(
            {"up-fixed",
             "The up vector is the same for all patches. For a patch that looks that way, up and direction are "
             "parallel, and the hemicube has no frame. " +
                 lies,
             "What is up on a floor?",
             refused(
                 ways, [k](const MyPolygon& from) { return !usable(axis(k, 1.0f), from.normal); }, "up vector")});
    all.push_back({"up-along-normal", "The up vector is the normal, which is the direction already. " + lies,
                   "Which vectors of a patch lie in it?",
                   refused(
                       ways, [](const MyPolygon&) { return true; }, "parallel")});
    all.push_back({"up-zero", "The up vector has no length. " + lies, "Between which two points is your up vector?",
                   refused(
                       ways, [](const MyPolygon&) { return true; }, "up vector: found")});
    return all;
}

}  // namespace

std::vector<Mistake> cameraMistakes(const Ways& ways) {
    std::vector<Mistake> all;
    for (const std::vector<Mistake>& some : {buffers(ways), places(ways), directions(ways), upVectors(ways)})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader
