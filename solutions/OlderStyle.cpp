// The six functions as the course used to write them: iterators, plain counters, doubles among the floats. It is here
// to show that such a file still compiles unchanged, and that it gives the same light.

#include "ProgRef.h"

using namespace std;

extern vector<MyPolygon*> polygons;
extern vector<MyVertex*> vertices;

// The older rule: the brightest patch by radiosity alone, whatever its area.
static bool isDarker(const MyPolygon* first, const MyPolygon* second) {
    return sqr_length(first->unshot_rad) < sqr_length(second->unshot_rad);
}

MyPolygon* maxenergy_patch() {
    if (polygons.empty()) return NULL;
    return *max_element(polygons.begin(), polygons.end(), isDarker);
}

MyPolygon* calcAnalyticalFF() {
    MyPolygon* source = maxenergy_patch();
    vector<MyPolygon*>::iterator it;
    for (it = polygons.begin(); it != polygons.end(); it++) {
        MyPolygon* target = *it;
        target->formF = 0.0;
        if (target == source) continue;

        Vec3f u = target->center - source->center;
        float r = length(u);
        if (r == 0.0) continue;
        u = normalize(u);

        float cosSource = max(dot(source->normal, u), 0.0f);
        float cosTarget = max(dot(target->normal, -u), 0.0f);
        target->formF = cosSource * cosTarget * target->area * M_1_PI / (r * r);
    }
    return source;
}

bool distributeEnergy(MyPolygon* maxP) {
    if (maxP == NULL) return false;

    Vec3f power = maxP->area * maxP->unshot_rad;
    for (vector<MyPolygon*>::iterator it = polygons.begin(); it != polygons.end(); ++it) {
        if (*it == maxP) continue;
        double share = (double)(*it)->formF / (*it)->area;
        Vec3f delta = share * power * (*it)->diffuse;
        (*it)->rad += delta;
        (*it)->unshot_rad += delta;
    }
    maxP->unshot_rad = Vec3f(0.0, 0.0, 0.0);
    return true;
}

void colorReconstruction() {
    for (unsigned int i = 0; i < vertices.size(); i++) {
        vertices[i]->color = Vec3f(0.0, 0.0, 0.0);
        vertices[i]->rad = Vec3f(0.0, 0.0, 0.0);
        vertices[i]->colorcount = 0;
    }

    vector<MyPolygon*>::iterator it;
    for (it = polygons.begin(); it != polygons.end(); it++) {
        Vec3f rad = (*it)->rad;
        (*it)->color = rad * M_1_PI;
        for (int j = 0; j < (*it)->vertices; j++) {
            MyVertex* corner = vertices[(*it)->vertex[j]];
            corner->color += (*it)->color;
            corner->rad += rad;
            corner->colorcount++;
        }
    }

    vector<MyVertex*>::iterator v;
    for (v = vertices.begin(); v != vertices.end(); v++) {
        int count = (*v)->colorcount;
        if (count > 0) {
            (*v)->color /= (float)count;
            (*v)->rad /= (float)count;
        }
    }
}

void renderPatchIDs() {
    int i, j;
    for (i = 0; i < (int)polygons.size(); i++) {
        int id = i + 1;
        if (polygons[i]->vertices == 4)
            glBegin(GL_QUADS);
        else
            glBegin(GL_TRIANGLES);
        glColor3ub((GLubyte)(id / 65536), (GLubyte)(id / 256 % 256), (GLubyte)(id % 256));
        for (j = 0; j < polygons[i]->vertices; j++) {
            Vec3f position = vertices[polygons[i]->vertex[j]]->position;
            glVertex3f(position[0], position[1], position[2]);
        }
        glEnd();
    }
}

MyPolygon* calcFF(Hemicube* hemicube) {
    for (unsigned int i = 0; i < polygons.size(); i++) polygons[i]->formF = 0.0f;
    MyPolygon* p = maxenergy_patch();
    if (!p) return NULL;

    // A frame of the patch: from its middle to its first corner, and the normal that its first two edges give.
    Vec3f a = vertices[p->vertex[0]]->position;
    Vec3f b = vertices[p->vertex[1]]->position;
    Vec3f c = vertices[p->vertex[2]]->position;
    Vec3f n = normalize(cross(b - a, c - a));
    Vec3f up = a - p->center;
    assert(dot(n, p->normal) > 0.5);

    hemicube->renderScene(p->center, up, n, &renderPatchIDs);
    hemicube->readIndexBuffer();

    int x, y;
    for (y = 0; y < hemicube->rendersize; y++) {
        for (x = 0; x < hemicube->rendersize; x++) {
            int index = hemicube->getIndex(x, y);
            if (index != 0) polygons[index - 1]->formF += hemicube->getDeltaFormFactor(x, y);
        }
    }
    return p;
}
