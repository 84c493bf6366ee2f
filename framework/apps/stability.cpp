// The table of hard cases: what every method makes of each.

#include <cmath>
#include <cstdio>
#include <iostream>

#include "apps/CommandLine.h"
#include "engine/HardCases.h"
#include "engine/RoomSolver.h"

namespace {

using namespace radlab::engine;

constexpr Method methods[] = {Method::point,    Method::polygon,    Method::exact,
                              Method::hemicube, Method::hemisphere, Method::visibility};
constexpr Solver solvers[] = {Solver::matrix, Solver::shooting, Solver::links};

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

bool printPairs(std::size_t rays) {
    std::cout << "| pair of patches | F(0→1) |";
    for (const Method method : methods) std::cout << ' ' << nameOf(method) << " |";
    std::cout << "\n| --- | --- |";
    for (std::size_t i = 0; i < std::size(methods); ++i) std::cout << " --- |";
    std::cout << '\n';
    bool held = true;
    for (const HardCase& hard : hardCases()) {
        char truth[40];
        std::snprintf(truth, sizeof truth, "%.12g", hard.truth);
        std::cout << "| " << hard.what << " | " << truth << " |";
        for (const Method method : methods) std::cout << ' ' << cell(hard, method, rays, held) << " |";
        std::cout << std::endl;
    }
    return held;
}

// The relative error of the worst patch.
std::string cell(const HardRoom& room, Solver solver, bool& held) {
    const double allowed = allowedError(room, solver);
    if (std::isinf(allowed)) return "not made for it";
    const double error = errorOf(room, solver);
    held = held && error <= allowed;
    if (room.truth.empty()) return error == 0.0 ? "refused" : "**not refused**";
    char text[40];
    std::snprintf(text, sizeof text, error <= allowed ? "%.1e" : "**%.1e**", error);
    return text;
}

bool printRooms() {
    std::cout << "\n| room | patches |";
    for (const Solver solver : solvers) std::cout << ' ' << nameOf(solver) << " |";
    std::cout << "\n| --- | --- | --- | --- | --- |\n";
    bool held = true;
    for (const HardRoom& room : hardRooms()) {
        std::cout << "| " << room.what << " | " << room.geometry.patches.size() << " |";
        for (const Solver solver : solvers) std::cout << ' ' << cell(room, solver, held) << " |" << std::flush;
        std::cout << std::endl;
    }
    return held;
}

bool print(std::size_t rays) {
    const bool pairs = printPairs(rays), rooms = printRooms();
    std::cout << (pairs && rooms ? "every method holds every case that it is made for\n"
                                 : "errors in bold are larger than allowed\n");
    return pairs && rooms;
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
