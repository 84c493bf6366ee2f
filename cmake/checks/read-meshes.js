// Reads meshes as three.js does, and holds them against the scene and the table of patches that were written with them:
//   node read-meshes.js FOLDER-OF-three SCENE.x3d NAME
// for NAME.glb, NAME.gltf, NAME.ply and NAME.csv. The folder is that of Debian's libjs-three (r111): a page that uses
// three.js without modules reads files by the same two loaders.
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const vm = require('vm');
const [, , three, sceneFile, name] = process.argv;

globalThis.window = globalThis;  // the loaders are a browser's
globalThis.THREE = require(path.resolve(three, 'build/three.js'));
for (const loader of ['GLTFLoader', 'PLYLoader'])
    vm.runInThisContext(fs.readFileSync(path.join(three, 'examples/js/loaders', loader + '.js'), 'utf8'));

function bytesOf(file) {
    const bytes = fs.readFileSync(file);
    return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
}

// Each row as an object by the names of its columns.
function tableOf(file) {
    const lines = fs.readFileSync(file, 'utf8').trim().split('\n').filter(line => !line.startsWith('#'));
    const columns = lines[0].split(',');
    return lines.slice(1).map(line => Object.fromEntries(line.split(',').map((cell, i) => [columns[i], Number(cell)])));
}

// What the scene's Viewpoints say themselves.
function viewpointsOf(file) {
    const numbers = (node, field) => node.match(new RegExp(`\\b${field}=["']([^"']*)`))[1].split(/\s+/).map(Number);
    return (fs.readFileSync(file, 'utf8').match(/<Viewpoint[^>]*>/g) || []).map(node => {
        const [x, y, z, angle] = numbers(node, 'orientation');
        return {
            position: new THREE.Vector3(...numbers(node, 'position')),
            turn: new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(x, y, z).normalize(), angle),
            degrees: numbers(node, 'fieldOfView')[0] * 180 / Math.PI,
        };
    });
}

function measuresOf(meshes) {
    const found = { vertices: 0, triangles: 0, area: 0, colours: [], box: new THREE.Box3() };
    const corner = [0, 1, 2].map(() => new THREE.Vector3());
    for (const { geometry: { attributes: { position, color }, index }, opacity } of meshes) {
        assert.strictEqual(color.count, position.count, 'a colour for each vertex');
        found.vertices += position.count;
        found.triangles += index.count / 3;
        found.box.union(new THREE.Box3().setFromBufferAttribute(position));
        for (let i = 0; i < index.count; i += 3) {
            corner.forEach((at, k) => at.fromBufferAttribute(position, index.getX(i + k)));
            found.area += new THREE.Triangle(...corner).getArea();
        }
        for (let i = 0; i < position.count; ++i) found.colours.push([color.getX(i), color.getY(i), color.getZ(i)].map(c => opacity * c));
    }
    return found;
}

const near = (found, expected, within, what) =>
    assert(Math.abs(found - expected) <= within, `${what}: found ${found}, expected ${expected} within ${within}`);

function holdAgainstTable(found, patches, what) {
    const area = patches.reduce((sum, patch) => sum + patch.area, 0);
    near(found.area, area, 1e-5 * area, what + ', area');
    const size = found.box.getSize(new THREE.Vector3()).length();
    const centres = new THREE.Box3();
    for (const { x, y, z } of patches) centres.expandByPoint(new THREE.Vector3(x, y, z));
    const widest = Math.sqrt(2 * Math.max(...patches.map(patch => patch.area)));
    assert(found.box.clone().expandByScalar(1e-5 * size).containsBox(centres), what + ': a patch outside the box');
    assert(centres.expandByScalar(2 * widest).containsBox(found.box), what + ': a vertex far from all patches');
}

function holdCameras(cameras, viewpoints, what) {
    assert.strictEqual(cameras.length, viewpoints.length, what + ', cameras');
    cameras.forEach((camera, i) => {
        const { position, turn, degrees } = viewpoints[i];
        const at = camera.getWorldPosition(new THREE.Vector3());
        near(at.distanceTo(position), 0, 1e-4 * (1 + position.length()), what + ', place of the camera');
        near(camera.getWorldQuaternion(new THREE.Quaternion()).angleTo(turn), 0, 2e-3, what + ', turn of the camera');
        near(camera.fov, degrees, 1e-3, what + ', field of view');
    });
}

function readGltf(file) {
    const data = file.endsWith('.glb') ? bytesOf(file) : fs.readFileSync(file, 'utf8');
    return new Promise((done, failed) => new THREE.GLTFLoader().parse(data, '', done, failed));
}

async function holdGltf(file, patches) {
    const { scene } = await readGltf(file);
    scene.updateMatrixWorld(true);
    const meshes = [], cameras = [];
    scene.traverse(node => { if (node.isMesh) meshes.push(node); if (node.isCamera) cameras.push(node); });
    for (const { material, geometry } of meshes) {
        assert(material.isMeshBasicMaterial, file + ': unlit');
        assert.strictEqual(material.vertexColors, THREE.VertexColors, file + ': vertex colours are used');
        assert.strictEqual(material.color.getHex(), 0xffffff, file + ': nothing multiplies the colours');
        assert.strictEqual(geometry.attributes._radiosity.count, geometry.attributes.position.count, file + ': radiosities');
    }
    const found = measuresOf(meshes.map(({ geometry, material }) => ({ geometry, opacity: material.opacity })));
    holdAgainstTable(found, patches, file);
    holdCameras(cameras, viewpointsOf(sceneFile), file);
    return found;
}

function holdPly(file, patches) {
    const header = fs.readFileSync(file, 'latin1').split('end_header')[0];
    const found = measuresOf([{ geometry: new THREE.PLYLoader().parse(bytesOf(file)), opacity: 1 }]);
    holdAgainstTable(found, patches, file);
    assert.strictEqual(found.vertices, Number(header.match(/element vertex (\d+)/)[1]), file + ', vertices');
    assert.strictEqual(patches.length, Number(header.match(/element face (\d+)/)[1]), file + ', faces');
    return found;
}

// PLY has the colours as a display takes them, glTF linear ones, which the opacity of the material multiplies.
function holdColours(ply, gltf) {
    const encoded = light => light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
    gltf.colours.forEach((colour, i) => colour.forEach((light, c) => {
        assert(light >= 0 && light <= 1, `vertex ${i}: a colour of ${light}`);
        near(ply.colours[i][c], encoded(light), 0.503 / 255, `vertex ${i}, colour in PLY and glTF`);
    }));
}

(async () => {
    const patches = tableOf(name + '.csv');
    const binary = await holdGltf(name + '.glb', patches), text = await holdGltf(name + '.gltf', patches);
    assert.deepStrictEqual(text, binary, 'the two forms of glTF differ');
    const ply = holdPly(name + '.ply', patches);
    assert.strictEqual(ply.vertices, binary.vertices, 'vertices in PLY and glTF');
    assert.strictEqual(ply.triangles, binary.triangles, 'triangles in PLY and glTF');
    holdColours(ply, binary);
    const isLit = patches.some(patch => patch.B_r + patch.B_g + patch.B_b > 0);
    assert.strictEqual(binary.colours.some(colour => Math.max(...colour) > 0.2), isLit, 'colours bright enough to see');
})();
