// Extension 3, solved: a mirror by a second pass.

#include "Extensions.h"

// x - 2 (n·(x - p)) n: to the plane and as far again beyond it.
static glm::mat4 reflectionAt(const Vec3f& point, const Vec3f& n) {
    glm::mat4 reflection(1.0f);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) reflection[column][row] -= 2.0f * n[column] * n[row];
    reflection[3] = glm::vec4(2.0f * dot(n, point) * n, 1.0f);
    return reflection;
}

void mirrorScene(const MirrorPass& pass, const Vec3f& point, const Vec3f& normal, const Vec3f& reflectance,
                 radlab::Image& picture) {
    const Vec3f n = normalize(normal);
    const glm::vec4 inFront(n, -dot(n, point));
    const radlab::Image seen = pass.draw(reflectionAt(point, n), inFront, true);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (pass.showsMirror(x, y)) picture.at(x, y) += reflectance * seen.at(x, y);
}
