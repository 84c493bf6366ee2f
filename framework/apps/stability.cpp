// The table of hard cases: what every method makes of each.

#include <cmath>
#include <cstdio>
#include <iostream>

#include "apps/CommandLine.h"
#include "engine/HardCases.h"

namespace {

using namespace radlab::engine;

constexpr Method methods[] = {Method::point, Method::polygon, Method::exact, Method::hemisphere, Method::visibility};

// The relative error, absolute where the truth is 0; in brackets where the method is not made for the case.
std::string cell(const HardCase& hard, Method method, std::size_t rays, bool& held) {
    const double error = std::abs(formFactorOf(hard, method, rays) - hard.truth);
    const double allowed = allowedError(hard, method, rays);
    held = held && error <= allowed;
    char text[40];
    const double shown = hard.truth > 0.0 ? error / hard.truth : error;
    std::snprintf(text, sizeof text, std::isinf(allowed) ? "(%.1e)" : error <= allowed ? "%.1e" : "**%.1e**", shown);
    return text;
}

bool print(std::size_t rays) {
    std::cout << "| case | F(0→1) |";
    for (const Method method : methods) std::cout << ' ' << nameOf(method) << " |";
    std::cout << "\n| --- | --- | --- | --- | --- | --- | --- |\n";
    bool held = true;
    for (const HardCase& hard : hardCases()) {
        char truth[40];
        std::snprintf(truth, sizeof truth, "%.12g", hard.truth);
        std::cout << "| " << hard.what << " | " << truth << " |";
        for (const Method method : methods) std::cout << ' ' << cell(hard, method, rays, held) << " |";
        std::cout << std::endl;
    }
    std::cout << (held ? "every method holds every case that it is made for\n"
                       : "errors in bold are larger than allowed\n");
    return held;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Prints the relative error of every method in every hard case; in brackets where it is not made for it.");
    std::size_t rays = 4096;
    app.add_option("--rays", rays, "Rays from a patch, or for a pair")
        ->capture_default_str()
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 32));
    return radlab::runCommandLine(app, argc, argv, [&] { return print(rays) ? 0 : 1; });
}
