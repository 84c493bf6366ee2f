#include "display/PatchArrays.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "course/DataFormat.h"
#include "gl/Context.h"

namespace radlab {

PatchArrays::PatchArrays() {
    firstCorner.reserve(polygons.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) addPatch(i);
}

void PatchArrays::addPatch(std::size_t patch) {
    const MyPolygon& polygon = *polygons[patch];
    const auto middle = static_cast<GLuint>(points.size());
    const auto corners = static_cast<GLuint>(polygon.vertices);
    points.push_back({glm::vec3(0.0f), {0, 0, 0, 255}});
    vertexOf.push_back(-1);
    firstCorner.push_back(points.size());
    for (GLuint k = 0; k < corners; ++k) {
        const Vec3f& position = vertices[static_cast<std::size_t>(polygon.vertex[k])]->position;
        points.push_back({position, {0, 0, 0, 255}});
        points[middle].position += position / static_cast<float>(corners);
        vertexOf.push_back(polygon.vertex[k]);
        const GLuint here = middle + 1 + k, next = middle + 1 + (k + 1) % corners;
        triangles.insert(triangles.end(), {middle, here, next});
        lines.insert(lines.end(), {here, next});
    }
}

void PatchArrays::paint(Point& point, const glm::vec3& color) {
    for (int c = 0; c < 3; ++c)
        point.color[c] = static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(color[c], 0.0f, 1.0f)));
}

void PatchArrays::paintPatch(std::size_t patch, const glm::vec3& color) {
    const std::size_t end = patch + 1 < firstCorner.size() ? firstCorner[patch + 1] - 1 : points.size();
    Point& middle = points[firstCorner[patch] - 1];
    paint(middle, color);
    for (std::size_t i = firstCorner[patch]; i < end; ++i) std::copy_n(middle.color, 4, points[i].color);
}

void PatchArrays::setColors(const std::vector<glm::vec3>& ofPatches) {
    RADLAB_CHECK(ofPatches.size() == patchCount());
    for (std::size_t i = 0; i < ofPatches.size(); ++i) paintPatch(i, ofPatches[i]);
}

void PatchArrays::setColors(const std::vector<glm::vec3>& ofVertices, const std::vector<glm::vec3>& ofMiddles) {
    RADLAB_CHECK(ofMiddles.size() == patchCount());
    std::size_t patch = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        paint(points[i], vertexOf[i] < 0 ? ofMiddles[patch++] : ofVertices.at(static_cast<std::size_t>(vertexOf[i])));
}

void PatchArrays::setIdColors() {
    for (std::size_t i = 0; i < patchCount(); ++i) {
        const std::size_t id = i + 1;
        paintPatch(i, glm::vec3(id >> 16 & 255, id >> 8 & 255, id & 255) / 255.0f);
    }
}

void PatchArrays::bindPositions() const {
    gl().bindBuffer(GL_ARRAY_BUFFER, 0);
    gl().bindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Point), &points[0].position);
}

void PatchArrays::draw() const {
    if (points.empty()) return;
    bindPositions();
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Point), points[0].color);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.size()), GL_UNSIGNED_INT, triangles.data());
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
}

void PatchArrays::drawOutlines() const {
    if (points.empty()) return;
    bindPositions();
    glDrawElements(GL_LINES, static_cast<GLsizei>(lines.size()), GL_UNSIGNED_INT, lines.data());
    glDisableClientState(GL_VERTEX_ARRAY);
}

void PatchArrays::drawOutline(std::size_t patch) const {
    RADLAB_CHECK(patch < patchCount());
    const std::size_t end = patch + 1 < firstCorner.size() ? firstCorner[patch + 1] - 1 : points.size();
    glBegin(GL_LINE_LOOP);
    for (std::size_t i = firstCorner[patch]; i < end; ++i) glVertex3fv(&points[i].position[0]);
    glEnd();
}

}  // namespace radlab
