#include "apps/HandoutScene.h"

#include "scene/X3dReader.h"

namespace radlab {

HandoutScene::HandoutScene(const std::string& name, float patchSize)
    : scene(readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + name + ".x3d")),
      mesh(scene.vertices, scene.faces, patchSize, patchSize),
      geometry(engine::geometryOf(scene, mesh)) {}

engine::FormFactorOptions handoutMethod(engine::Method method, std::size_t rays, int hemicubeSize) {
    engine::FormFactorOptions options;
    options.method = method;
    options.rays = rays;
    options.hemicubeSize = hemicubeSize;
    return engine::settled(options);
}

engine::Polygon unitSquare(const engine::Point& center, const engine::Point& right, const engine::Point& up) {
    return engine::Polygon({center - 0.5 * right - 0.5 * up, center + 0.5 * right - 0.5 * up,
                            center + 0.5 * right + 0.5 * up, center - 0.5 * right + 0.5 * up});
}

}  // namespace radlab
