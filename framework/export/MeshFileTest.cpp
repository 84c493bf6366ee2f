#include "export/MeshFile.h"

#include <bit>
#include <cstring>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "base/Error.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"
#include "engine/SceneTestHelp.h"
#include "export/Base64.h"

using namespace radlab;
using namespace radlab::engine;

namespace {

// A box whose radiosities all differ.
struct Solved {
    explicit Solved(bool flat = false, double patchSize = 200.0) : cut("cornell_2.x3d", patchSize) {
        for (std::size_t i = 0; i < cut.mesh.patches.size(); ++i) radiosity.emplace_back(0.1 * double(i), 1.0, 2.0);
        const PatchShading shading = flat ? PatchShading(radiosity) : PatchShading(cut.mesh, cut.geometry, radiosity);
        mesh = solvedMesh(cut.scene, cut.mesh, radiosity, shading, 0.5f);
    }
    CutScene cut;
    std::vector<Point> radiosity;
    SolvedMesh mesh;
};

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

Vec3f vectorAt(const std::string& bytes, std::size_t at) {
    return {std::bit_cast<float>(wordAt(bytes, at)), std::bit_cast<float>(wordAt(bytes, at + 4)),
            std::bit_cast<float>(wordAt(bytes, at + 8))};
}

// The two chunks of a .glb file.
struct Glb {
    explicit Glb(const std::string& bytes) {
        CHECK(bytes.substr(0, 4) == "glTF");
        CHECK(wordAt(bytes, 8) == bytes.size());
        const std::size_t length = wordAt(bytes, 12);
        json = nlohmann::json::parse(bytes.substr(20, length));
        CHECK(wordAt(bytes, 20 + length) == json["buffers"][0]["byteLength"]);
        buffer = bytes.substr(28 + length);
    }
    std::size_t start(std::size_t accessor) const {
        return json["bufferViews"][std::size_t(json["accessors"][accessor]["bufferView"])]["byteOffset"];
    }
    nlohmann::json json;
    std::string buffer;
};

}  // namespace

TEST_CASE("glTF: positions, colours, radiosities and triangles come back as they were, whole and aligned") {
    const test::Folder folder;
    for (const bool flat : {false, true}) {
        const Solved solved(flat);
        writeMesh(folder / "box.glb", solved.mesh);
        const Glb glb(readFile(folder / "box.glb"));
        REQUIRE(glb.json["meshes"][0]["primitives"].size() == solved.mesh.parts.size());
        for (std::size_t p = 0; p < solved.mesh.parts.size(); ++p) {
            const MeshPart& part = solved.mesh.parts[p];
            const nlohmann::json& primitive = glb.json["meshes"][0]["primitives"][p];
            const auto compare = [&](const char* name, Vec3f MeshVertex::*member) {
                const std::size_t start = glb.start(primitive["attributes"][name]);
                CHECK(start % 4 == 0);
                for (std::size_t i = 0; i < part.vertices.size(); ++i)
                    REQUIRE(vectorAt(glb.buffer, start + 12 * i) == part.vertices[i].*member);
            };
            compare("POSITION", &MeshVertex::position);
            compare("COLOR_0", &MeshVertex::color);
            compare("_RADIOSITY", &MeshVertex::radiosity);
            std::size_t at = glb.start(primitive["indices"]);
            for (const MeshPatch& patch : part.patches)
                for (int k = 1; k + 1 < patch.vertices; ++k)
                    for (const int corner : {0, k, k + 1}) {
                        std::uint16_t index;
                        std::memcpy(&index, glb.buffer.data() + at, sizeof index);
                        REQUIRE(index == patch.vertex[std::size_t(corner)]);
                        at += sizeof index;
                    }
        }
    }
}

TEST_CASE("a pane, blended by the alpha of its material, has the colour that is displayed") {
    const test::Folder folder;
    Solved solved;
    const auto pane = std::make_shared<Material>(*solved.mesh.parts[0].material);
    solved.mesh.parts[0].material = pane;
    for (const float transparency : {0.6f, 1.0f}) {
        pane->transparency = transparency;
        writeMesh(folder / "box.glb", solved.mesh);
        const Glb glb(readFile(folder / "box.glb"));
        CHECK(glb.json["materials"][0]["alphaMode"] == "BLEND");
        const float alpha = glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3];
        CHECK(alpha == doctest::Approx(1.0f - transparency));
        const std::size_t start = glb.start(glb.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]);
        for (std::size_t i = 0; i < solved.mesh.parts[0].vertices.size(); ++i) {
            const Vec3f found = vectorAt(glb.buffer, start + 12 * i);
            const Vec3f displayed = solved.mesh.parts[0].vertices[i].color;
            for (int c = 0; c < 3; ++c) {
                REQUIRE(found[c] <= 1.0f);
                REQUIRE(alpha * found[c] == doctest::Approx(std::min(displayed[c], alpha)));
            }
        }
    }
}

TEST_CASE("glTF as text holds the buffer of the binary form") {
    const test::Folder folder;
    const Solved solved;
    writeMesh(folder / "box.glb", solved.mesh);
    writeMesh(folder / "box.gltf", solved.mesh);
    const std::string uri = nlohmann::json::parse(readFile(folder / "box.gltf"))["buffers"][0]["uri"];
    CHECK(uri == "data:application/octet-stream;base64," + base64(Glb(readFile(folder / "box.glb")).buffer));
}

TEST_CASE("base64 of RFC 4648's own examples") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("colours are exposure times radiance, and vertices are shared where the shading is smooth, alone") {
    const Solved smooth, flat(true);
    std::size_t ofSmooth = 0, ofFlat = 0, corners = 0;
    for (const MeshPart& part : smooth.mesh.parts) ofSmooth += part.vertices.size();
    for (const MeshPart& part : flat.mesh.parts) {
        ofFlat += part.vertices.size();
        for (const MeshPatch& patch : part.patches) {
            corners += std::size_t(patch.vertices);
            for (int k = 0; k < patch.vertices; ++k) {
                const MeshVertex& vertex = part.vertices[patch.vertex[std::size_t(k)]];
                CHECK(vertex.radiosity == patch.radiosity);
                CHECK(vertex.color.g == doctest::Approx(0.5 / 3.14159265358979));
            }
        }
    }
    CHECK(ofFlat == corners);
    CHECK(ofSmooth == smooth.cut.mesh.corners.size());
}

TEST_CASE("more than 65,535 vertices of a material have indices of 32 bits") {
    const test::Folder folder;
    const Solved solved(true, 4.0);
    writeMesh(folder / "box.glb", solved.mesh);
    const Glb glb(readFile(folder / "box.glb"));
    bool both[2] = {};
    for (std::size_t p = 0; p < solved.mesh.parts.size(); ++p) {
        const std::size_t accessor = glb.json["meshes"][0]["primitives"][p]["indices"];
        const bool isLong = solved.mesh.parts[p].vertices.size() > 65535;
        both[isLong] = true;
        CHECK(glb.json["accessors"][accessor]["componentType"] == (isLong ? 5125 : 5123));
    }
    CHECK(both[0]);
    CHECK(both[1]);
}

TEST_CASE("PLY: as many bytes as its header says, and the first vertex and face as they were") {
    const test::Folder folder;
    const Solved solved;
    writeMesh(folder / "box.ply", solved.mesh);
    const std::string bytes = readFile(folder / "box.ply");
    const std::string end = "end_header\n";
    const std::size_t start = bytes.find(end) + end.size();
    std::size_t corners = 0, length = start;
    for (const MeshPart& part : solved.mesh.parts) {
        corners += part.vertices.size();
        for (const MeshPatch& patch : part.patches) length += 1 + 4 * std::size_t(patch.vertices) + 12;
    }
    CHECK(bytes.find("element vertex " + std::to_string(corners) + "\n") != bytes.npos);
    CHECK(bytes.size() == length + 15 * corners);
    CHECK(vectorAt(bytes, start) == solved.mesh.parts[0].vertices[0].position);
    const MeshPatch& patch = solved.mesh.parts[0].patches[0];
    CHECK(int(bytes[start + 15 * corners]) == patch.vertices);
    CHECK(wordAt(bytes, start + 15 * corners + 1) == patch.vertex[0]);
    CHECK(vectorAt(bytes, start + 15 * corners + 1 + 4 * std::size_t(patch.vertices)) == patch.radiosity);
}

TEST_CASE("another ending is refused, and nothing is written") {
    const test::Folder folder;
    CHECK_THROWS_WITH_AS(writeMesh(folder / "box.obj", Solved().mesh),
                         doctest::Contains("expected .glb, .gltf or .ply"), Error);
    CHECK(folder.entries() == 0);
}
