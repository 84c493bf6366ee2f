#include "viewer/Viewer.h"

namespace radlab {

std::vector<Banner> Viewer::banners() const {
    using Kind = Banner::Kind;
    std::vector<Banner> all;
    if (!crash.empty()) {
        const std::size_t end = crash.find('\n');
        all.push_back({Kind::problem, crash.substr(0, end), crash.substr(end + 1)});
    }
    if (!compileError.empty()) {
        const char* rest = functions ? "\nThe functions from before stay in use."
                                     : "\nSave the file once it is mended; it is built again.";
        const std::string source = options.library.source.filename().string();
        const bool own = compileError.find(source) != std::string::npos;  // else it is the build or the machine
        all.push_back({Kind::problem, own ? source + " does not compile" : "the build failed", compileError + rest});
    }
    if (const auto& problem = solving->problem()) {
        const std::size_t end = problem->text.find('\n');
        all.push_back({problem->notWritten ? Kind::stub : Kind::problem, problem->text.substr(0, end),
                       end == std::string::npos ? "" : problem->text.substr(end + 1)});
    }
    if (build.isBuilding()) all.push_back({Kind::note, "Compiling", options.library.source.filename().string()});
    if (notice && noticeTime.seconds() < noticeSeconds) all.push_back(*notice);
    return all;
}

}  // namespace radlab
