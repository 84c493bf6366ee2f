#include "grader/stages/MirrorMistakes.h"

namespace radlab::grader {

namespace {

// x - factor (n·x - offset) n.
glm::mat4 householder(const Vec3f& n, float offset, float factor = 2.0f) {
    glm::mat4 m(1.0f);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) m[column][row] -= factor * n[column] * n[row];
    m[3] = glm::vec4(factor * offset * n, 1.0f);
    return m;
}

Vec3f unit(const MirrorPlane& plane) { return glm::normalize(plane.normal); }
float offsetOf(const MirrorPlane& plane) { return glm::dot(unit(plane), plane.point); }

MirrorWay carrying(const std::function<glm::mat4(const MirrorPlane&)>& world) {
    MirrorWay way;
    way.world = world;
    return way;
}

MirrorWay clipping(const std::function<glm::vec4(const MirrorPlane&)>& clip) {
    MirrorWay way;
    way.clip = clip;
    return way;
}

MirrorWay combining(const std::function<Vec3f(const MirrorPlane&, const Vec3f&, const Vec3f&)>& combined) {
    MirrorWay way;
    way.combined = combined;
    return way;
}

glm::vec4 keepsAll(const MirrorPlane&) { return {0.0f, 0.0f, 0.0f, 1.0f}; }

std::vector<MirrorMistake> matrices() {
    const std::string twice = "From a point to the plane it is (n·(x - p)). How far from the plane is its image?";
    return {
        {"not-reflected", "The scene is drawn once more as it is, not its mirror image.",
         "Which matrix carries a point to its image?", carrying([](const MirrorPlane&) { return glm::mat4(1.0f); })},
        {"offset-missing",
         "The reflection is at the plane through the origin with the mirror's normal: the point of the plane plays no "
         "part, so the image is "
         "right only where the mirror goes through the origin.",
         "Where does your matrix carry a point of the mirror itself? It should stay where it is.",
         carrying([](const MirrorPlane& p) { return householder(unit(p), 0.0f); })},
        {"offset-sign",
         "The plane's offset has the wrong sign, so the reflection is at a plane on the other side of the origin.",
         "Where does your matrix carry a point of the mirror itself? It should stay where it is.",
         carrying([](const MirrorPlane& p) { return householder(unit(p), -offsetOf(p)); })},
        {"offset-once", "The offset is added once, not twice: points of the mirror do not stay where they are.", twice,
         carrying([](const MirrorPlane& p) { return householder(unit(p), 0.5f * offsetOf(p)); })},
        {"projected",
         "Points are carried to the plane, and not as far again beyond it: all of the image lies flat in the mirror.",
         twice, carrying([](const MirrorPlane& p) { return householder(unit(p), offsetOf(p), 1.0f); })},
        {"normal-not-normalised",
         "The normal is used at the length that it has. The formula takes its length for 1: in n·(x - p) n it counts "
         "twice.",
         "What is dot(n, n) in your matrix?",
         carrying([](const MirrorPlane& p) { return householder(p.normal, glm::dot(p.normal, p.point)); })},
        {"transposed",
         "The matrix is transposed: the shift stands in its last row, not in its last column. GLM's m[column][row] "
         "names the column first.",
         "Which four numbers of a matrix move a point? Multiply one by hand.",
         carrying([](const MirrorPlane& p) { return glm::transpose(householder(unit(p), offsetOf(p))); })},
        {"reflected-at-the-point",
         "Points are reflected at the point of the plane, 2p - x, not at the plane: up becomes down, and right becomes "
         "left.",
         "Which part of x - p changes its sign, and which stays as it is?", carrying([](const MirrorPlane& p) {
             glm::mat4 m(-1.0f);
             m[3] = glm::vec4(2.0f * p.point, 1.0f);
             return m;
         })},
    };
}

std::vector<MirrorMistake> sides() {
    MirrorWay counter, both;
    counter.clockwise = false;
    both = clipping(keepsAll);
    both.clockwise = false;
    return {
        {"winding-not-flipped",
         "In the image, corners that go round counter-clockwise go round clockwise. Without that, fronts are taken for "
         "backs, and the mirror "
         "shows things inside out.",
         "Hold a page with a round arrow to a mirror: which way does the arrow go round?", counter},
        {"not-clipped",
         "What lies behind the mirror is carried to its front, and stands in the way. Only what lies in front has an "
         "image.",
         "Which plane tells what lies in front of the mirror from what lies behind it?", clipping(keepsAll)},
        {"clipped-nor-flipped",
         "What lies behind the mirror is not cut away, and the corners' order is not turned round.",
         "Which plane tells what lies in front of the mirror, and which way do the corners of an image go round?",
         both},
        {"clipped-other-side", "What lies in front of the mirror is cut away, and what lies behind it is kept.",
         "For which side of the plane is n·(x - p) positive?",
         clipping([](const MirrorPlane& p) { return glm::vec4(-unit(p), offsetOf(p)); })},
        {"clip-offset-missing", "The clip plane goes through the origin, not through the mirror.",
         "The plane's fourth number: what must it be so that a point of the mirror gives 0?",
         clipping([](const MirrorPlane& p) { return glm::vec4(unit(p), 0.0f); })},
        {"clip-offset-sign",
         "The clip plane's offset has the wrong sign: the plane lies on the other side of the origin.",
         "The plane's fourth number: what must it be so that a point of the mirror gives 0?",
         clipping([](const MirrorPlane& p) { return glm::vec4(unit(p), offsetOf(p)); })},
    };
}

std::vector<MirrorMistake> lights() {
    MirrorWay everywhere;
    everywhere.everywhere = true;
    return {
        {"reflectance-missing", "All of the light is reflected: the reflectance plays no part.",
         "What share of the radiance does the mirror send on, channel by channel?",
         combining([](const MirrorPlane&, const Vec3f& held, const Vec3f& seen) { return held + seen; })},
        {"reflectance-of-one-channel", "All channels are reflected by the reflectance of the red one.",
         "Multiply channel by channel: Vec3f times Vec3f.",
         combining(
             [](const MirrorPlane& p, const Vec3f& held, const Vec3f& seen) { return held + p.reflectance.r * seen; })},
        {"replaced", "The reflection takes the place of what the mirror's own surface sends, which is lost.",
         "What does the picture hold at the mirror before the second pass, and where does that light go?",
         combining([](const MirrorPlane& p, const Vec3f&, const Vec3f& seen) { return p.reflectance * seen; })},
        {"own-light-scaled", "The mirror's own light is multiplied by the reflectance, too.",
         "Whose light is reflected, and whose is sent by the mirror's surface itself?",
         combining(
             [](const MirrorPlane& p, const Vec3f& held, const Vec3f& seen) { return p.reflectance * (held + seen); })},
        {"mixed", "The own light is reduced to what is not reflected. Both are added as they are.",
         "What does the picture hold at the mirror before the second pass, and where does that light go?",
         combining([](const MirrorPlane& p, const Vec3f& held, const Vec3f& seen) {
             return glm::mix(held, seen, p.reflectance);
         })},
        {"everywhere", "The second picture is added to all pixels, not to those alone that show the mirror.",
         "Through which pixels does one look into the mirror?", everywhere},
    };
}

}  // namespace

glm::mat4 MirrorWay::worldFor(const MirrorPlane& plane) const {
    return world ? world(plane) : householder(unit(plane), offsetOf(plane));
}

glm::vec4 MirrorWay::clipFor(const MirrorPlane& plane) const {
    return clip ? clip(plane) : glm::vec4(unit(plane), -offsetOf(plane));
}

Vec3f MirrorWay::combine(const MirrorPlane& plane, const Vec3f& held, const Vec3f& seen) const {
    return combined ? combined(plane, held, seen) : held + plane.reflectance * seen;
}

std::vector<MirrorMistake> mirrorMistakes() {
    std::vector<MirrorMistake> all;
    for (const std::vector<MirrorMistake>& some : {lights(), sides(), matrices()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace radlab::grader
