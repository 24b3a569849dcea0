// Speed of the element and particle solvers: a block of n^3 elastoplastic hexahedra, random initial
// velocities large enough to yield, no contact. Prints ns per element-step, median of the repeats,
// of the wall and of the processor (all threads together).
// block [n] [steps] [repeats] [backend] [threads] [simd] [precision] [hourglass or selective]
// [assembly]

#include "solver/Solver.h"
#include "support/solverModel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

using namespace fpm;

int main(int argc, char** argv)
{
    const auto word = [&](int i, const char* preset) {
        return std::string(argc > i ? argv[i] : preset);
    };
    const Index n = Index(std::atoi(word(1, "100").c_str()));
    const int steps = std::atoi(word(2, "10").c_str()), repeats = std::atoi(word(3, "5").c_str());
    const std::string form = word(8, "stiffness"), precision = word(7, "double");

    const HourglassForm hourglass = form == "physical"  ? HourglassForm::physical
                                    : form == "viscous" ? HourglassForm::viscous
                                                        : HourglassForm::stiffness;
    Model model = test::boxModel({n, n, n}, {double(n), double(n), double(n)},
                                 test::aluminium(PartKind::elastoplastic, hourglass));
    if (form == "selective") model.parts[0].hexahedron = HexahedronForm::selective;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> speed(-2e4, 2e4);
    for (Index node = 0; node < Index(model.mesh.points.size()); ++node)
        model.initialVelocities.push_back(
            {"random", {node}, {speed(random), speed(random), speed(random)}});
    Control& control = model.control;
    control.backend = word(4, "serial");
    control.threads = std::atoi(word(5, "0").c_str());
    control.simd = word(6, "auto");
    control.precision = precision == "mixed"    ? Precision::mixed
                        : precision == "single" ? Precision::single
                                                : Precision::double_;
    if (word(9, "patch") == "gather") control.assembly = Assembly::gather;
    const auto solver = makeSolver(model);
    solver->start();
    solver->advance(1, 3);
    std::vector<double> costs, work;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const double before = solver->times().total;
        const std::clock_t begin = std::clock();
        solver->advance(1, steps);
        work.push_back(1e9 * double(std::clock() - begin) / CLOCKS_PER_SEC
                       / (double(steps) * n * n * n));
        costs.push_back(1e9 * (solver->times().total - before) / (double(steps) * n * n * n));
    }
    std::sort(costs.begin(), costs.end());
    std::sort(work.begin(), work.end());
    const StepTimes& t = solver->times();
    std::printf("%d^3 %s %s: median %.1f min %.1f ns per element-step (processor: median %.1f min "
                "%.1f; elements %.0f %%, nodes %.0f %%), "
                "plastic work %.3g, checksum %016llx\n",
                int(n), solver->description().c_str(), form.c_str(), costs[costs.size() / 2],
                costs[0], work[work.size() / 2], work[0], 100 * t.element / t.total,
                100 * t.node / t.total, solver->energies().plastic,
                static_cast<unsigned long long>(solver->stateChecksum()));
}
