#include "apps/RenderTable.h"

#include <ostream>

#include "base/Interrupts.h"
#include "base/NumberText.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"

namespace radlab {

namespace {

void appendNumbers(std::string& line, const engine::Point& values) {
    for (int c = 0; c < 3; ++c) appendNumber(line += ',', values[c], 9);
}

std::string rowOf(std::size_t i, const SceneInput& input, const RenderSolution& solution) {
    const engine::Polygon& patch = input.geometry.patches[i];
    std::string line = std::to_string(i) + "," + std::to_string(input.geometry.faceOf[i]);
    appendNumbers(line, patch.center);
    appendNumbers(line, patch.normal);
    appendNumber(line += ',', patch.area, 9);
    appendNumbers(line, solution.surfaces.reflectance[i]);
    appendNumbers(line, solution.surfaces.emission[i]);
    appendNumbers(line, solution.radiosity[i]);
    if (!solution.standardError.empty()) appendNumbers(line, solution.standardError[i]);
    return line;
}

}  // namespace

void writeTable(const std::string& file, const SceneInput& input, const RenderSolution& solution) {
    ProgressBar bar("writing " + file, static_cast<double>(solution.radiosity.size()), "rows");
    writeFile(file, [&](std::ostream& out) {
        out << "# " << input.summary << "\nid,face,x,y,z,nx,ny,nz,area,rho_r,rho_g,rho_b,E_r,E_g,E_b,B_r,B_g,B_b"
            << (solution.standardError.empty() ? "" : ",se_r,se_g,se_b") << '\n';
        for (std::size_t i = 0; i < solution.radiosity.size(); ++i) {
            Interrupts::check();
            bar.show(static_cast<double>(i));
            out << rowOf(i, input, solution) << '\n';
        }
    });
}

}  // namespace radlab
