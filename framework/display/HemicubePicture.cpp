#include "display/HemicubePicture.h"

#include <functional>

#include "course/Hemicube.h"
#include "display/FalseColor.h"

namespace radlab {

namespace {

const glm::vec3 unused(0.13f);

Image unfolded(const Hemicube& hemicube, const std::function<glm::vec3(int x, int y)>& color) {
    const int edge = hemicube.rendersize;
    Image image(edge, edge, unused);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            if (hemicube.getDeltaFormFactor(x, y) > 0.0f) image.at(x, edge - 1 - y) = color(x, y);
    return image;
}

}  // namespace

Image hemicubeIds(const Hemicube& hemicube) {
    return unfolded(hemicube, [&](int x, int y) { return idColor(static_cast<std::size_t>(hemicube.getIndex(x, y))); });
}

Image hemicubeWeights(const Hemicube& hemicube) {
    const int middle = hemicube.rendersize / 2;
    const float largest = hemicube.getDeltaFormFactor(middle, middle);
    return unfolded(hemicube, [&](int x, int y) { return heatColor(hemicube.getDeltaFormFactor(x, y) / largest); });
}

}  // namespace radlab
