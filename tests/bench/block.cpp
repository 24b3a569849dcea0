// Speed of the element and particle solvers: a block of n^3 hexahedra without contact, random
// initial velocities large enough to yield. The variants are built together and run in turn, so
// that what disturbs the machine disturbs all of them. One line of JSON a variant.
//
//   bench_block <n> <steps> <repeats> <variant> ...
//   variant: backend,threads,simd,precision,form[,random]
//   random: nodes and elements of the input in random order, before they are renumbered
//   form: elastic stiffness physical viscous selective (all but the first elastoplastic)

#include "base/Error.h"
#include "run/StepBytes.h"
#include "solver/Solver.h"
#include "support/solverModel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <sstream>

using namespace fpm;

namespace {

constexpr int warmUp = 3; ///< steps before the clock counts

struct Variant {
    std::string text, backend, simd, precision, form, order;
    int threads = 0;

    explicit Variant(const std::string& given) : text(given)
    {
        std::istringstream words(given);
        std::string count;
        for (std::string* word : {&backend, &count, &simd, &precision, &form, &order})
            std::getline(words, *word, ',');
        threads = std::atoi(count.c_str());
    }
    Part part() const
    {
        Part made = test::aluminium(form == "elastic" ? PartKind::elastic : PartKind::elastoplastic,
                                    form == "physical"  ? HourglassForm::physical
                                    : form == "viscous" ? HourglassForm::viscous
                                                        : HourglassForm::stiffness);
        if (form == "selective") {
            made.hexahedron = HexahedronForm::selective;
            made.rotation = RotationForm::hughesWinget;
        }
        return made;
    }
    void applyTo(Control& control) const
    {
        control.backend = backend;
        control.threads = threads;
        control.simd = simd;
        control.precision = precision == "mixed"    ? Precision::mixed
                            : precision == "single" ? Precision::single
                                                    : Precision::double_;
    }
};

struct Running {
    Variant variant;
    Precision precision;
    std::unique_ptr<Solver> solver;
    StepTimes before; ///< of the warm-up
    std::vector<double> seconds;
};

/// Nodes and elements in random order.
void shuffle(Mesh& mesh)
{
    std::mt19937 random(2);
    std::shuffle(mesh.hexahedra.begin(), mesh.hexahedra.end(), random);
    std::vector<Index> number(mesh.points.size());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    std::vector<Point> points(number.size());
    for (std::size_t i = 0; i < number.size(); ++i) points[std::size_t(number[i])] = mesh.points[i];
    mesh.points = points;
    for (auto& corners : mesh.hexahedra)
        for (Index& node : corners) node = number[std::size_t(node)];
}

Model block(Index n, bool inRandomOrder)
{
    Model model;
    model.mesh = test::boxMesh({n, n, n}, {double(n), double(n), double(n)});
    if (inRandomOrder) shuffle(model.mesh);
    renumber(model.mesh);
    model.parts = {test::aluminium(PartKind::elastic, HourglassForm::stiffness)};
    model.control.endTime = 1;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> speed(-2e4, 2e4);
    for (Index node = 0; node < Index(model.mesh.points.size()); ++node)
        model.initialVelocities.push_back(
            {"random", {node}, {speed(random), speed(random), speed(random)}});
    return model;
}

void print(const Running& run, std::size_t elements, int steps)
{
    const StepTimes &t = run.solver->times(), &before = run.before;
    const double total = t.total - before.total;
    std::printf("{\"variant\": \"%s\", \"description\": \"%s\", \"elements\": %zu, \"steps\": %d, "
                "\"seconds\": [",
                run.variant.text.c_str(), run.solver->description().c_str(), elements, steps);
    for (std::size_t i = 0; i < run.seconds.size(); ++i)
        std::printf("%s%.9g", i > 0 ? ", " : "", run.seconds[i]);
    std::printf("], \"elementShare\": %.4g, \"nodeShare\": %.4g, \"bytesPerElementStep\": %.4g, "
                "\"deviceBytes\": %zu, "
                "\"plasticWork\": %.4g, \"checksum\": \"%016llx\"}\n",
                (t.element - before.element) / total, (t.node - before.node) / total,
                double(bytesOfStep(*run.solver, run.precision)) / double(elements),
                run.solver->fields().bytes(), run.solver->ledger().energies().plastic,
                static_cast<unsigned long long>(stateChecksum(*run.solver)));
}

int measure(int argc, char** argv)
{
    const int steps = std::atoi(argv[2]), repeats = std::atoi(argv[3]);
    std::map<bool, Model> models; // by whether their input was in random order
    std::vector<Running> runs;
    std::size_t elements = 0;
    for (int i = 4; i < argc; ++i) {
        const Variant variant(argv[i]);
        const bool random = variant.order == "random";
        if (!models.contains(random)) models[random] = block(Index(std::atoi(argv[1])), random);
        Model& model = models[random];
        elements = model.mesh.hexahedra.size();
        model.parts[0] = variant.part();
        variant.applyTo(model.control);
        try {
            runs.push_back({variant, model.control.precision, makeSolver(model), {}, {}});
        } catch (const Error& error) {
            if (error.code() != ExitCode::device) throw;
            std::printf("{\"variant\": \"%s\", \"skipped\": \"%s\"}\n", variant.text.c_str(),
                        error.what());
            continue;
        }
        runs.back().solver->start();
        runs.back().solver->advance(1, warmUp);
        runs.back().before = runs.back().solver->times();
    }
    for (int repeat = 0; repeat < repeats; ++repeat)
        for (Running& run : runs) {
            const double before = run.solver->times().total;
            run.solver->advance(1, steps);
            run.seconds.push_back(run.solver->times().total - before);
        }
    for (const Running& run : runs) {
        print(run, elements, steps);
        if (run.solver->clock().failed)
            throw Error(ExitCode::numericalStop, run.variant.text + " did not stay stable");
    }
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 5) {
        std::fprintf(stderr, "usage: bench_block <n> <steps> <repeats> "
                             "<backend,threads,simd,precision,form[,random]> ...\n");
        return 2;
    }
    try {
        return measure(argc, argv);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
