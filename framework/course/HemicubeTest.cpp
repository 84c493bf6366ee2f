#include "course/Hemicube.h"

#include <cmath>
#include <limits>
#include <map>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "course/TestMeshes.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

void drawIds() {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::size_t id = i + 1;
        glBegin(polygons[i]->vertices == 4 ? GL_QUADS : GL_TRIANGLES);
        glColor3ub((id >> 16) & 255, (id >> 8) & 255, id & 255);
        for (int k = 0; k < polygons[i]->vertices; ++k) glVertex3fv(&vertices[polygons[i]->vertex[k]]->position[0]);
        glEnd();
    }
}

// Form factors from patch s to all patches.
std::vector<double> row(Hemicube& hemicube, std::size_t s) {
    const MyPolygon& shooter = *polygons[s];
    hemicube.renderScene(shooter.center, vertices[shooter.vertex[0]]->position - shooter.center, shooter.normal,
                         drawIds);
    hemicube.readIndexBuffer();
    std::vector<double> factors(polygons.size());
    for (int y = 0; y < hemicube.rendersize; ++y)
        for (int x = 0; x < hemicube.rendersize; ++x)
            if (const int id = hemicube.getIndex(x, y); id > 0) factors[id - 1] += hemicube.getDeltaFormFactor(x, y);
    return factors;
}

std::unique_ptr<PatchMesh> cube(float scale, float size, const Vec3f& shift = Vec3f(0)) {
    Faces room;
    room.addRoom(shift, shift + Vec3f(scale), material(Vec3f(0.5f)));
    auto mesh = room.mesh(size);
    mesh->publish();
    return mesh;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

}  // namespace

TEST_CASE("delta form factors sum to 1, are equal under the cube's symmetries and 0 in the corners") {
    const auto context = GlContext::offscreen();
    for (const int size : {2, 64, 256}) {
        CAPTURE(size);
        const Hemicube hemicube(size);
        double total = 0.0;
        for (int y = 0; y < 2 * size; ++y)
            for (int x = 0; x < 2 * size; ++x) {
                const float delta = hemicube.getDeltaFormFactor(x, y);
                total += delta;
                CHECK(delta == hemicube.getDeltaFormFactor(y, x));
                CHECK(delta == hemicube.getDeltaFormFactor(2 * size - 1 - x, y));
            }
        CHECK(std::abs(total - 1.0) < 1e-4);
        CHECK(hemicube.getDeltaFormFactor(0, 0) == 0.0f);
        CHECK(hemicube.getDeltaFormFactor(size / 2 - 1, size / 2 - 1) == 0.0f);
        CHECK(hemicube.getDeltaFormFactor(size / 2, size / 2) > 0.0f);
    }
}

TEST_CASE("the middle pixel's delta form factor is its area over pi") {
    const auto context = GlContext::offscreen();
    const Hemicube hemicube(256);
    CHECK(hemicube.getDeltaFormFactor(256, 256) == Approx(std::pow(2.0 / 256, 2) / M_PI).epsilon(1e-4));
}

TEST_CASE("rows sum to 1 in a closed room, at every scale and place") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(64);
    for (const float scale : {1e-6f, 1.0f, 552.8f, 1e6f})
        for (const float shift : {0.0f, 10.0f}) {
            CAPTURE(scale);
            const auto mesh = cube(scale, scale / 4, Vec3f(shift * scale));
            for (std::size_t s = 0; s < polygons.size(); s += 7) {
                CHECK(sum(row(hemicube, s)) == Approx(1.0).epsilon(1e-6));
                CHECK(row(hemicube, s)[s] == 0.0);
            }
        }
}

TEST_CASE("a neighbour that touches the shooter is never lost, however thin the shooter") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(128);
    for (const float width : {1.0f, 1e-2f, 1e-4f}) {
        CAPTURE(width);
        Faces faces;
        faces.add({{0, 0, 0}, {width, 0, 0}, {width, 1, 0}, {0, 1, 0}});
        faces.add({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
        const auto mesh = faces.mesh(10.0f);
        mesh->publish();
        const double factor = row(hemicube, 0)[1];
        // A strip that is thin before the wall sees it in nearly half of its view, less what passes its ends.
        CHECK(factor > 0.18);
        CHECK(factor <= 0.5 + 1e-3);
    }
}

TEST_CASE("the near wall hides the far one, and behind the shooter nothing is seen") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(64);
    Faces faces;
    faces.add(square(0, true));
    faces.add({{-9, -9, 2}, {-9, 9, 2}, {9, 9, 2}, {9, -9, 2}});
    faces.add({{-90, -90, 3}, {-90, 90, 3}, {90, 90, 3}, {90, -90, 3}});
    faces.add({{-9, -9, -1}, {9, -9, -1}, {9, 9, -1}, {-9, 9, -1}});
    const auto mesh = faces.mesh(1000.0f);
    mesh->publish();
    const std::vector<double> factors = row(hemicube, 0);
    CHECK(factors[0] == 0.0);
    CHECK(factors[1] > 0.9);
    CHECK(factors[2] > 0.0);
    CHECK(factors[2] < 0.1);
    CHECK(factors[3] == 0.0);
}

TEST_CASE("the buffer's up is the up vector and its right is direction x up") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(32);
    const auto mesh = cube(2.0f, 2.0f);  // patch order: floor, ceiling, z low, z high, x low, x high
    hemicube.renderScene(Vec3f(1, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 1, 0), drawIds);
    hemicube.readIndexBuffer();
    CHECK(hemicube.getIndex(32, 32) == 2);
    CHECK(hemicube.getIndex(32, 62) == 4);
    CHECK(hemicube.getIndex(32, 1) == 3);
    CHECK(hemicube.getIndex(62, 32) == 6);
    CHECK(hemicube.getIndex(1, 32) == 5);
    CHECK(hemicube.getIndex(1, 1) == 0);
    CHECK(hemicube.getIndex(62, 62) == 0);
}

TEST_CASE("any up vector in the patch's plane gives the same form factors within the resolution") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(256);
    const auto mesh = cube(1.0f, 0.5f);
    const MyPolygon& shooter = *polygons[0];
    std::vector<std::map<int, double>> factors;
    for (const double angle : {0.0, 0.3, 0.9}) {
        const Vec3f up(std::cos(angle), 0.2, std::sin(angle));
        hemicube.renderScene(shooter.center, up, shooter.normal, drawIds);
        hemicube.readIndexBuffer();
        factors.emplace_back();
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) factors.back()[hemicube.getIndex(x, y)] += hemicube.getDeltaFormFactor(x, y);
    }
    for (const auto& [id, factor] : factors[0]) {
        CHECK(factors[1][id] == Approx(factor).epsilon(0.02));
        CHECK(factors[2][id] == Approx(factor).epsilon(0.02));
    }
}

TEST_CASE("an up vector or direction that gives no frame is refused with what is wrong") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(16);
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const Vec3f eye(0), up(0, 1, 0), direction(0, 0, 1);
    const auto message = [&](const Vec3f& e, const Vec3f& u, const Vec3f& d) -> std::string {
        try {
            hemicube.renderScene(e, u, d, [] { FAIL("draw must not be called"); });
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message(eye, Vec3f(0), direction).find("up vector: found (0.000000, 0.000000, 0.000000)") !=
          std::string::npos);
    CHECK(message(eye, Vec3f(nan, 0, 0), direction).find("up vector") != std::string::npos);
    CHECK(message(eye, Vec3f(infinity, 0, 0), direction).find("up vector") != std::string::npos);
    CHECK(message(eye, direction, direction).find("parallel to the direction") != std::string::npos);
    CHECK(message(eye, -2.0 * direction, direction).find("parallel to the direction") != std::string::npos);
    CHECK(message(eye, up, Vec3f(0)).find("direction vector") != std::string::npos);
    CHECK(message(eye, up, Vec3f(0, nan, 1)).find("direction vector") != std::string::npos);
    CHECK(message(Vec3f(nan, 0, 0), up, direction).find("eye") != std::string::npos);
}

TEST_CASE("sizes that are odd, too small or larger than this OpenGL are refused") {
    const auto context = GlContext::offscreen();
    for (const int size : {-2, 0, 1, 3, 255}) {
        CAPTURE(size);
        CHECK_THROWS_WITH_AS(Hemicube{size}, doctest::Contains("expected an even number"), Error);
    }
    CHECK_THROWS_WITH_AS(Hemicube{1 << 20}, doctest::Contains("picture size"), Error);
}

TEST_CASE("pixels outside the buffer are refused, and before a read-back all is background") {
    const auto context = GlContext::offscreen();
    const Hemicube hemicube(4);
    CHECK(hemicube.getIndex(7, 7) == 0);
    CHECK_THROWS_WITH_AS(hemicube.getIndex(8, 0), "hemicube pixel: found (8, 0), expected 0 to 7 each way", Error);
    CHECK_THROWS_AS(hemicube.getDeltaFormFactor(0, -1), Error);
}

TEST_CASE("IDs of 1, 2 and 3 bytes come back as they were drawn, whatever state the program was in") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(16);
    for (const GLenum capability : {GL_DITHER, GL_BLEND, GL_MULTISAMPLE, GL_LIGHTING, GL_FOG, GL_TEXTURE_2D,
                                    GL_CULL_FACE, GL_ALPHA_TEST, GL_POLYGON_STIPPLE, GL_STENCIL_TEST, GL_SCISSOR_TEST})
        glEnable(capability);
    glBlendFunc(GL_ONE, GL_ONE);
    glShadeModel(GL_SMOOTH);
    glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_PACK_ROW_LENGTH, 100);
    for (const int id : {1, 255, 256, 32767, 32768, 65535, 65536, 0xabcdef, 16777215}) {
        CAPTURE(id);
        const auto draw = [id] {
            glColor3ub((id >> 16) & 255, (id >> 8) & 255, id & 255);
            glBegin(GL_QUADS);
            for (const auto& [x, y] : {std::pair{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}) glVertex3f(x, y, 0.5f);
            glEnd();
        };
        hemicube.renderScene(Vec3f(0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), draw);
        hemicube.readIndexBuffer();
        CHECK(hemicube.getIndex(16, 16) == id);
        CHECK(hemicube.getIndex(9, 22) == id);
    }
}
