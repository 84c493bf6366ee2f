#include "apps/RenderMesh.h"

#include "export/MeshFile.h"

namespace radlab {

void writeSolution(const std::string& file, const PictureFlags& flags, const SceneInput& input,
                   const RenderSolution& solution, float exposure) {
    writeMesh(file,
              solvedMesh(input.scene, *input.mesh, solution.radiosity, shadingOf(flags, input, solution), exposure));
}

}  // namespace radlab
