// The six functions of the exercise, solved.

#include "ProgRef.h"

// Stage 1: the patch with the most unshot power ------------------------------------------------

static float unshotPower(const MyPolygon* patch) { return length(patch->unshot_rad) * patch->area; }

MyPolygon* maxenergy_patch() {
    const auto brightest = std::max_element(polygons.begin(), polygons.end(),
                                            [](MyPolygon* a, MyPolygon* b) { return unshotPower(a) < unshotPower(b); });
    return brightest == polygons.end() ? nullptr : *brightest;
}

// Stage 2: form factors, patch centre to patch centre ------------------------------------------

static float pointToPoint(const MyPolygon* from, const MyPolygon* to) {
    const Vec3f between = to->center - from->center;
    const float distance2 = sqr_length(between);
    if (distance2 == 0.0f) return 0.0f;
    const Vec3f direction = normalize(between);
    const float cosineFrom = std::max(dot(from->normal, direction), 0.0f);
    const float cosineTo = std::max(dot(to->normal, -direction), 0.0f);
    return cosineFrom * cosineTo * to->area * static_cast<float>(M_1_PI) / distance2;
}

MyPolygon* calcAnalyticalFF() {
    MyPolygon* shooter = maxenergy_patch();
    for (MyPolygon* patch : polygons) patch->formF = patch == shooter ? 0.0f : pointToPoint(shooter, patch);
    return shooter;
}

// Stage 3: shooting ----------------------------------------------------------------------------

bool distributeEnergy(MyPolygon* maxP) {
    if (!maxP) return false;
    for (MyPolygon* patch : polygons) {
        if (patch == maxP) continue;
        const Vec3f arriving = maxP->unshot_rad * (patch->formF * maxP->area / patch->area);
        const Vec3f reflected = patch->diffuse * arriving;
        patch->rad += reflected;
        patch->unshot_rad += reflected;
    }
    maxP->unshot_rad = Vec3f(0.0f);
    return true;
}

// Stage 4: colours to display ------------------------------------------------------------------

static void colorPatches() {
    for (MyPolygon* patch : polygons) patch->color = patch->rad * M_1_PI;
}

static void averageAtVertices() {
    for (MyVertex* vertex : vertices) {
        vertex->color = vertex->rad = Vec3f(0.0f);
        vertex->colorcount = 0;
    }
    for (MyPolygon* patch : polygons) {
        for (int i = 0; i < patch->vertices; ++i) {
            MyVertex* vertex = vertices[patch->vertex[i]];
            vertex->color += patch->color;
            vertex->rad += patch->rad;
            ++vertex->colorcount;
        }
    }
    for (MyVertex* vertex : vertices) {
        if (vertex->colorcount == 0) continue;
        vertex->color /= vertex->colorcount;
        vertex->rad /= vertex->colorcount;
    }
}

void colorReconstruction() {
    colorPatches();
    averageAtVertices();
}

// Stage 5: patches drawn as their IDs ----------------------------------------------------------

void renderPatchIDs() {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const MyPolygon* patch = polygons[i];
        const std::size_t id = i + 1;
        glBegin(patch->vertices == 4 ? GL_QUADS : GL_TRIANGLES);
        glColor3ub((id >> 16) & 255, (id >> 8) & 255, id & 255);
        for (int corner = 0; corner < patch->vertices; ++corner)
            glVertex3fv(&vertices[patch->vertex[corner]]->position[0]);
        glEnd();
    }
}

// Stage 6: form factors by hemicube ------------------------------------------------------------

MyPolygon* calcFF(Hemicube* hemicube) {
    for (MyPolygon* patch : polygons) patch->formF = 0.0f;
    MyPolygon* shooter = maxenergy_patch();
    if (!shooter) return nullptr;

    const Vec3f up = vertices[shooter->vertex[0]]->position - shooter->center;
    hemicube->renderScene(shooter->center, up, shooter->normal, renderPatchIDs);
    hemicube->readIndexBuffer();

    for (int y = 0; y < hemicube->rendersize; ++y) {
        for (int x = 0; x < hemicube->rendersize; ++x) {
            const int id = hemicube->getIndex(x, y);
            if (id > 0) polygons[id - 1]->formF += hemicube->getDeltaFormFactor(x, y);
        }
    }
    return shooter;
}
