#include "grader/worker/DrawIds.h"

#include <cstdint>
#include <vector>

#include "course/DataFormat.h"
#include "gl/OpenGL.h"

namespace radlab::grader {

namespace {

struct Corner {
    Vec3f position;
    std::uint8_t color[4];
};

void addTriangle(std::vector<Corner>& corners, const MyPolygon& patch, std::size_t id, int second) {
    for (const int k : {0, second, second + 1})
        corners.push_back({vertices[static_cast<std::size_t>(patch.vertex[k])]->position,
                           {static_cast<std::uint8_t>(id >> 16), static_cast<std::uint8_t>(id >> 8 & 255),
                            static_cast<std::uint8_t>(id & 255), 255}});
}

}  // namespace

void drawIds() {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < polygons.size(); ++i)
        for (int second = 1; second + 1 < polygons[i]->vertices; ++second)
            addTriangle(corners, *polygons[i], i + 1, second);
    if (corners.empty()) return;
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Corner), &corners[0].position);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Corner), corners[0].color);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
    glPopClientAttrib();
}

}  // namespace radlab::grader
