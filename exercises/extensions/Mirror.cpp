// Extension 3: a mirror by a second pass. Worth no marks; ./radlab check mirror judges it.
//
// Extensions.h brings all that ProgRef.h does, and MirrorPass and radlab::Image.

#include "Extensions.h"

// The picture shows the scene, and the mirror in it as a surface like any other. Add what the mirror shows: what the
// camera would see if there were a second world behind the mirror, its image. So draw the scene once more, with every
// point x carried to x - 2 (n·(x - p)) n, p being a point of the mirror's plane and n its normal of length 1 (glm::mat4
// m: m[column][row]). Only what lies in front of the mirror has an image, and in the image, corners that went round
// counter-clockwise go round clockwise. Add the radiance of the second picture, times the reflectance, to each pixel
// that shows the mirror, and to no other.
// You may call: pass.draw, pass.showsMirror, normalize, dot; picture.width, picture.height; picture.at(x, y) is a pixel
// that can be set.
void mirrorScene(const MirrorPass& pass, const Vec3f& point, const Vec3f& normal, const Vec3f& reflectance,
                 radlab::Image& picture) {
    // TODO extension 3
    (void)pass, (void)point, (void)normal, (void)reflectance, (void)picture;
    throw NotImplemented("mirrorScene");
}
