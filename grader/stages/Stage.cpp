#include "grader/stages/Stage.h"

#include <cstdio>

namespace radlab::grader {

std::string Stage::show(const Step&, std::size_t, double value) const {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", value);
    return text;
}

std::optional<Diagnosis> Stage::fit(const std::vector<Comparison>&) const { return std::nullopt; }

std::vector<std::unique_ptr<Stage>> allStages() {
    std::vector<std::unique_ptr<Stage>> stages;
    stages.push_back(maxenergyStage());
    stages.push_back(analyticalStage());
    stages.push_back(distributeStage());
    stages.push_back(colorStage());
    stages.push_back(patchIdStage());
    stages.push_back(hemicubeStage());
    return stages;
}

std::vector<std::unique_ptr<Stage>> extensionStages() {
    std::vector<std::unique_ptr<Stage>> stages;
    stages.push_back(hemisphereStage());
    stages.push_back(antialiasStage());
    stages.push_back(mirrorStage());
    return stages;
}

}  // namespace radlab::grader
