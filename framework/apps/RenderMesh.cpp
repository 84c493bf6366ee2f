#include "apps/RenderMesh.h"

#include "export/MeshFile.h"

namespace radlab {

void writeSolution(const std::string& file, const PictureFlags& flags, const SceneInput& input,
                   const RenderSolution& solution, const Image& radiance) {
    writeMesh(file, solvedMesh(input.scene, *input.mesh, solution.radiosity, shadingOf(flags, input, solution),
                               exposureOf(flags, radiance)));
}

}  // namespace radlab
