#include "solver/Performance.h"

#include "base/Format.h"
#include "io/AtomicFile.h"
#include "kernels/element/Gradient.h"
#include "solver/TimeLoop.h"

#include <chrono>
#include <cmath>

namespace fpm {

namespace {

std::size_t contactors(const Model& model)
{
    std::size_t sum = 0;
    for (const ContactPair& pair : model.contactPairs) sum += pair.contactorNodes.size();
    return sum;
}

/// Stable step of an element at given positions; negative when its volume is not positive.
double elementStep(const Solver& solver, const Model& model, const NodeValues& nodes, Index element)
{
    const SolverData& data = solver.data();
    const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
    Modes<double> x{};
    for (int c = 0; c < 3; ++c) {
        double corner[8], modes[8];
        for (std::size_t i = 0; i < 8; ++i)
            corner[i] = nodes.at(
                0, std::size_t(model.mesh.hexahedra[std::size_t(element)][i]))[std::size_t(c)];
        toModes(corner, modes);
        for (int m = 1; m < 8; ++m)
            (c == 0 ? x.mode[m].x : c == 1 ? x.mode[m].y : x.mode[m].z) = modes[m];
    }
    const Gradient<double> gradient = meanGradient(x);
    const double volume = gradient.volume64 / 64, square = gradientSquare512(gradient) / 512;
    if (!(volume > 0)) return -1;
    const double mass = data.elementMass[data.tileOf(element)
                                         + std::size_t(data.elementPlace[std::size_t(element)])];
    const double modulus = materialConstants(part).pressureWaveModulus;
    const double z = part.linearBulkViscosity;
    return std::sqrt(mass * volume / (2 * modulus * square)) * (std::sqrt(1 + z * z) - z);
}

} // namespace

std::string worstElement(Solver& solver, const Model& model)
{
    const NodeValues nodes = solver.nodeValues({});
    const std::vector<bool> deleted = solver.elementValues().deleted;
    Index worst = 0, inverted = 0;
    double least = 1e300;
    for (Index element = 0; element < Index(model.mesh.hexahedra.size()); ++element) {
        if (model.parts[std::size_t(model.mesh.partOf(element))].kind == PartKind::rigid) continue;
        if (deleted[std::size_t(element)]) continue;
        const double step = elementStep(solver, model, nodes, element);
        inverted += !(step > 0);
        if (step < least || !(step == step)) {
            least = step;
            worst = element;
            if (!(step == step)) break;
        }
    }
    const std::string name = model.mesh.parts[std::size_t(model.mesh.partOf(worst))].name;
    const std::string where = format("element {} of part {}", worst, name);
    if (!(least > 0))
        return where + (inverted > 1 ? format(" and {} others have", inverted - 1) : " has")
               + " no positive volume any more";
    return where + format(", stable step {}", least);
}

void reportPerformance(Solver& solver, const Model& model, Run& run)
{
    const StepTimes& t = solver.times();
    const std::int64_t steps = solver.clock().steps;
    const std::size_t elements = model.mesh.hexahedra.size();
    const double perStep = steps > 0 ? 1e9 * t.total / (double(steps) * double(elements)) : 0;
    const bool cpu = model.control.backend != "cuda";
    const double contactShare = t.total > 0 ? (t.contact + t.search) / t.total : 0;
    run.log.line(format("{} elements, {} contactors, {} steps, {} s: {} ns per element-step ({})",
                        elements, contactors(model), steps, toText(t.total, 4), toText(perStep, 4),
                        solver.description()));
    if (cpu && t.total > 0)
        run.log.line(format("  shares: elements {} %, contact {} % ({} searches), nodes {} %",
                            toText(100 * t.element / t.total, 3), toText(100 * contactShare, 3),
                            t.searches, toText(100 * t.node / t.total, 3)));
    const std::string share = cpu ? toText(contactShare, 4) : "null";
    writeFileAtomically(
        run.theCase.path("postProcessing/performance/0/performance.json"),
        format("{\n  \"elements\": {}, \"nodes\": {}, \"contactors\": {}, \"steps\": {},\n",
               elements, model.mesh.points.size(), contactors(model), steps)
            + format("  \"wallSeconds\": {}, \"nsPerElementStep\": {}, \"contactShare\": {}, "
                     "\"searches\": {},\n",
                     toText(t.total, 6), toText(perStep, 5), share, t.searches)
            + format("  \"backend\": \"{}\", \"precision\": \"{}\", \"description\": \"{}\",\n",
                     model.control.backend,
                     model.control.precision == Precision::double_ ? "double"
                     : model.control.precision == Precision::mixed ? "mixed"
                                                                   : "single",
                     solver.description())
            + format("  \"deviceBytes\": {}\n}\n", solver.deviceBytes()));
}

namespace {

void reportKernels(const Solver& solver, const Model& model, Log& log)
{
    bool elastic = false, plastic = false, general = false;
    for (const KernelGroup& group : solver.data().groups)
        (group.general                           ? general
         : group.kind == PartKind::elastoplastic ? plastic
                                                 : elastic) = true;
    const auto used = [&](bool here, const std::string& name) {
        log.line((here ? "  needed    " : "  left out  ") + name);
    };
    log.line("kernels of this scene:");
    used(elastic, "elastic hexahedra");
    used(plastic, "elastoplastic hexahedra (radial return)");
    used(general, "hexahedra with options chosen at run time (rotation)");
    for (const auto& [form, name] : {std::pair{HourglassForm::stiffness, "stiffness"},
                                     std::pair{HourglassForm::viscous, "viscous"},
                                     std::pair{HourglassForm::physical, "physical"}}) {
        bool here = false;
        for (const KernelGroup& group : solver.data().groups) here |= group.hourglass == form;
        used(here, std::string("hourglass control, ") + name);
    }
    used(!model.contactPairs.empty(), "contact search, tracking and force");
    bool friction = false;
    for (const ContactPair& pair : model.contactPairs) friction |= pair.friction > 0;
    used(friction, "friction");
    used(!solver.data().conditions.empty(), "drives and loads, ledger of nodal works");
    used(model.control.massDamping > 0, "mass damping");
    used(solver.data().rigidParts, "rigid parts (no element work)");
}

} // namespace

void reportDryRun(Solver& solver, const Model& model, Log& log)
{
    reportKernels(solver, model, log);
    std::size_t memory = solver.deviceBytes();
    log.line(format("{} nodes, {} elements in {} patches, {} contactors in {} pairs, {} MB",
                    model.mesh.points.size(), model.mesh.hexahedra.size(),
                    solver.data().patches.size(), contactors(model), model.contactPairs.size(),
                    toText(double(memory) / 1e6, 3)));
    log.line("limiting " + worstElement(solver, model));

    // A few real steps tell the step size with contact, and what a step costs.
    solver.advance(model.control.endTime, 50);
    const StepClock clock = solver.clock();
    const double steps = clock.step > 0 ? model.control.endTime / clock.step : 0;
    log.line(format("time step {} (elements alone {}, contact omega {}), about {} steps",
                    toText(clock.step, 4), toText(clock.elementStep, 4),
                    toText(clock.contactFrequency, 4), toText(steps, 3)));
    const double seconds =
        solver.times().total / double(std::max<std::int64_t>(1, clock.steps)) * steps;
    log.line(format("expected time {} s ({})", toText(seconds, 2), solver.description()));
}

} // namespace fpm
