#include "solver/Performance.h"

#include "base/Format.h"
#include "io/AtomicFile.h"
#include "solver/ElementStep.h"
#include "solver/PenaltyData.h"
#include "solver/RunForecast.h"
#include "solver/StepBytes.h"
#include "solver/StepSetters.h"
#include "solver/TimeLoop.h"

#include <algorithm>
#include <chrono>

namespace fpm {

namespace {

std::size_t contactors(const Model& model)
{
    std::size_t sum = 0;
    for (const ContactPair& pair : model.contactPairs) sum += pair.contactorNodes.size();
    return sum;
}

/// Stable step of an element at given positions; negative when it is turned inside out.
double stepOf(const Solver& solver, const Model& model, const NodeValues& nodes, Index element)
{
    const SolverData& data = solver.data();
    std::array<Point, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = nodes.at(0, std::size_t(model.mesh.hexahedra[std::size_t(element)][i]));
    return stableStep(model.parts[std::size_t(model.mesh.partOf(element))], corners,
                      data.massOf(element));
}

/// Names of the pairs a contact node belongs to.
std::string pairsOf(const SolverData& data, const Model& model, Index node)
{
    std::string names;
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number) {
        const bool here =
            std::any_of(data.passes.begin(), data.passes.end(), [&](const ContactPassSetup& pass) {
                const auto among = [&](const std::vector<Index>& nodes) {
                    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
                };
                return pass.pair == number && (among(pass.contactor) || among(pass.target));
            });
        if (here) names += (names.empty() ? "" : ", ") + model.contactPairs[number].name;
    }
    return names;
}

/// Largest stiffness of the springs of a pair.
double largestStiffnessOf(const SolverData& data, std::size_t pair)
{
    double most = 0;
    for (const ContactPassSetup& pass : data.passes)
        if (pass.pair == pair) most = std::max(most, largestStiffness(pass));
    return most;
}

/// Whether the springs of contact bounded the last step.
bool contactBoundsStep(const StepClock& clock, const Control& control)
{
    const double element = 2 / clock.elementStep, contact = clock.contactFrequency;
    return contact >= element
           || contact * control.timeStepSafety * clock.stableStep > control.contactStepLimit;
}

} // namespace

std::string worstElement(Solver& solver, const Model& model)
{
    const NodeValues nodes = solver.nodeValues({});
    const std::vector<bool> deleted = solver.elementValues().deleted;
    Index worst = 0, inverted = 0;
    double least = 1e300;
    for (Index element = 0; element < Index(model.mesh.hexahedra.size()); ++element) {
        if (isRigid(model.parts[std::size_t(model.mesh.partOf(element))].kind)) continue;
        if (deleted[std::size_t(element)]) continue;
        const double step = stepOf(solver, model, nodes, element);
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

void reportMassScaling(const Solver& solver, Log& log)
{
    const SolverData& data = solver.data();
    if (data.scaledElements == 0) return;
    double own = 0, scaled = 0;
    for (std::size_t i = 0; i < data.nodeMass.size(); ++i) {
        own += data.ownNodeMass[i];
        scaled += data.nodeMass[i];
    }
    log.line(format("mass scaling: {} added to {} ({} %), {} of {} elements",
                    toText(scaled - own, 5), toText(own, 5), toText(100 * (scaled / own - 1), 5),
                    data.scaledElements, data.elementCount));
}

std::string stepLimit(Solver& solver, const Model& model)
{
    const StepClock clock = solver.clock();
    if (model.control.fixedTimeStep > 0) return "timeStep.fixed";
    if (model.control.maximumTimeStep > 0 && clock.step >= model.control.maximumTimeStep)
        return "timeStep.maximum";
    if (!contactBoundsStep(clock, model.control)) return worstElement(solver, model);
    const ContactBound limit = solver.contactLimit();
    if (limit.part >= 0)
        return format("contact springs on rigidFree part {}, omega {}",
                      model.parts[std::size_t(limit.part)].name, limit.frequency);
    if (limit.node < 0) return worstElement(solver, model);
    const Point at = solver.nodeValues({limit.node}).at(0, 0);
    return format("contact pair {}: node {} at ({} {} {}), omega {}",
                  pairsOf(solver.data(), model, limit.node), limit.node, at[0], at[1], at[2],
                  limit.frequency);
}

void reportPairs(Solver& solver, const Model& model, Log& log)
{
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number) {
        const ContactPair& pair = model.contactPairs[number];
        const PairForce now = solver.pairForce(number);
        std::string line =
            format("pair {}: {} in touch, springs up to {}, held {}", pair.name, now.active,
                   largestStiffnessOf(solver.data(), number), now.spring);
        if (pair.friction > 0) line += format(", lost to friction {}", now.friction);
        if (pair.normalDamping > 0) line += format(", lost to contact damping {}", now.damping);
        log.line(line);
    }
}

namespace {

std::string hexText(std::uint64_t value)
{
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[(value >> shift) & 15];
    return text;
}

const char* precisionName(Precision precision)
{
    return precision == Precision::double_ ? "double"
           : precision == Precision::mixed ? "mixed"
                                           : "single";
}

/// A number a pair, for programs that ask which friction does anything.
std::string frictionWorks(Solver& solver, const Model& model)
{
    std::string text;
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number)
        if (model.contactPairs[number].friction > 0)
            text += format("  \"frictionWork {}\": {},\n", model.contactPairs[number].name,
                           toText(solver.pairForce(number).friction));
    return text;
}

/// Steps, and the pair and node whose springs bounded the last one.
std::string stepFigures(Solver& solver, const Model& model)
{
    const StepClock clock = solver.clock();
    const bool given = model.control.fixedTimeStep > 0 || model.control.maximumTimeStep > 0;
    const bool contact = !given && clock.elementStep > 0 && contactBoundsStep(clock, model.control);
    return format("  \"time\": {}, \"lastStep\": {}, \"elementStep\": {},\n"
                  "  \"contactLimitedBy\": \"{}\",\n",
                  toText(clock.time), toText(clock.step), toText(clock.elementStep),
                  contact ? stepLimit(solver, model) : "");
}

/// What scripts read of a run; null is what was not timed, or has no meaning.
std::string performanceText(Solver& solver,
                            const Model& model,
                            const std::string& checksum,
                            const std::string& runId)
{
    const StepTimes& t = solver.times();
    const StepClock clock = solver.clock();
    const double steps = double(clock.steps), elements = double(model.mesh.hexahedra.size()),
                 touching = double(contactors(model)), contact = t.contact + t.search;
    const bool known = t.element > 0;
    const auto over = [](double part, double whole, bool given, int digits) {
        return given && whole > 0 ? toText(part / whole, digits) : std::string("null");
    };
    return format("{\n  \"runId\": \"{}\",\n", runId)
           + format("  \"elements\": {}, \"nodes\": {}, \"contactors\": {}, \"steps\": {},\n",
                    model.mesh.hexahedra.size(), model.mesh.points.size(), contactors(model),
                    clock.steps)
           + format(
               "  \"wallSeconds\": {}, \"nsPerElementStep\": {}, \"nsPerContactorStep\": {},\n",
               toText(t.total, 6), over(1e9 * t.total, steps * elements, true, 5),
               over(1e9 * contact, steps * touching, known, 5))
           + format("  \"contactShare\": {}, \"searches\": {},\n", over(contact, t.total, known, 4),
                    t.searches)
           + format("  \"backend\": \"{}\", \"precision\": \"{}\", \"algorithm\": \"{}\",\n",
                    model.control.backend, precisionName(model.control.precision),
                    model.control.paperAlgorithm ? "paper" : "default")
           + format("  \"description\": \"{}\", \"threads\": {},\n", solver.description(),
                    toText(t.threads, 4))
           + stepFigures(solver, model) + frictionWorks(solver, model)
           + format(
               "  \"bytesPerElementStep\": {}, \"deviceBytes\": {}, \"checksum\": \"{}\"\n}\n",
               over(double(bytesOfStep(solver.data(), model.control.precision)), elements, true, 4),
               solver.deviceBytes(), checksum);
}

} // namespace

void reportPerformance(Solver& solver, const Model& model, Run& run, const std::string& runId)
{
    const StepTimes t = solver.times();
    const std::int64_t steps = solver.clock().steps;
    const std::size_t elements = model.mesh.hexahedra.size();
    const double perStep = steps > 0 ? 1e9 * t.total / (double(steps) * double(elements)) : 0;
    run.log.line(format("{} elements, {} contactors, {} steps, {} s: {} ns per element-step ({})",
                        elements, contactors(model), steps, toText(t.total, 4), toText(perStep, 4),
                        solver.description()));
    if (t.threads > 0 && t.threads < threadCount(model.control) - 0.05)
        run.log.line(format("  {} threads on average: other programs had the other cores",
                            toText(t.threads, 3)));
    if (t.element > 0 && t.total > 0)
        run.log.line(format("  shares: elements {} %, contact {} % ({} searches), nodes {} %",
                            toText(100 * t.element / t.total, 3),
                            toText(100 * (t.contact + t.search) / t.total, 3), t.searches,
                            toText(100 * t.node / t.total, 3)));
    const std::string checksum = hexText(solver.stateChecksum());
    run.log.line("stateChecksum = " + checksum);
    writeFileAtomically(run.theCase.path("postProcessing/performance/0/performance.json"),
                        performanceText(solver, model, checksum, runId));
}

namespace {

void reportKernels(const Solver& solver, const Model& model, Log& log)
{
    const auto used = [&](bool here, const std::string& name) {
        log.line((here ? "  needed    " : "  left out  ") + name);
    };
    std::array<bool, Laws::size> laws{};
    std::array<bool, Elements::size> elements{};
    for (const KernelGroup& group : solver.data().groups)
        laws[std::size_t(group.kernel.law)] = elements[std::size_t(group.kernel.element)] = true;
    log.line("kernels of this scene:");
    std::size_t number = 0;
    Laws::visitAll(
        [&]<class Law>() { used(laws[number++], std::string("hexahedra, law: ") + Law::name); });
    number = 0;
    Elements::visitAll([&]<class Element>() {
        const char* control = Element::hourglass;
        used(elements[number++], std::string("hexahedra, ") + Element::name
                                     + (control ? std::string(", hourglass ") + control : ""));
    });
    bool friction = false, faces = false, surfaces = false;
    for (const ContactPair& pair : model.contactPairs) {
        friction |= pair.friction > 0;
        (pair.surface < 0 ? faces : surfaces) = true;
    }
    used(faces, "contact search, tracking and force");
    used(surfaces, "contact with analytic surfaces");
    used(friction, "friction");
    used(!solver.data().conditions.empty(), "drives and loads, ledger of nodal works");
    used(model.control.massDamping > 0, "mass damping");
    used(model.control.relaxationTolerance > 0, "dynamic relaxation");
    used(!solver.data().pressureFaceCondition.empty(), "pressures");
    used(!solver.data().body.bodies.empty(), "free rigid bodies");
    used(solver.data().rigidParts, "rigid parts (no element work)");
}

/// Stiff contact springs on light nodes can need shorter steps than any element.
void reportContactCost(const StepClock& clock, const Control& control, Log& log)
{
    if (control.fixedTimeStep > 0 || !(clock.stableStep > 0)) return;
    Control free = control;
    free.maximumTimeStep = 0;
    const double ratio = control.timeStepSafety * clock.elementStep / steadyStep(clock, free);
    if (ratio > 2)
        log.line(format("contact needs {} times as many steps as the elements alone; a smaller "
                        "normalScale of that pair needs fewer, for deeper overlaps",
                        toText(ratio, 3)));
}

} // namespace

void reportDryRun(Solver& solver, const Model& model, Run& run)
{
    Log& log = run.log;
    reportKernels(solver, model, log);
    log.line(format("{} nodes, {} elements in {} patches, {} contactors in {} pairs, {} MB",
                    model.mesh.points.size(), model.mesh.hexahedra.size(),
                    solver.data().patches.size(), contactors(model), model.contactPairs.size(),
                    toText(double(solver.deviceBytes()) / 1e6, 3)));
    reportMassScaling(solver, log);
    // A few real steps tell the step size with contact, and what a step costs.
    solver.advance(model.control.endTime, 50);
    const StepClock clock = solver.clock();
    log.line(format("time step {} (elements alone {}, contact omega {})", toText(clock.step, 4),
                    toText(clock.elementStep, 4), toText(clock.contactFrequency, 4)));
    log.line("limited by " + stepLimit(solver, model));
    reportStepSetters(stepSetters(solver.data(), model), log);
    reportContactCost(clock, model.control, log);
    const double step = clock.stableStep > 0 ? steadyStep(clock, model.control) : clock.step;
    const RunForecast forecast = forecastRun(solver, model, run.theCase.root(), step, -1);
    const double aStep = solver.times().total / double(std::max<std::int64_t>(1, clock.steps));
    reportForecast(forecast, aStep, log);
    if (const std::string why = endlessReason(clock, model.control, -1); !why.empty())
        log.warning(why);
    log.line(format("expected time {} s for the steps, {} s for the frames ({})",
                    toText(aStep * forecast.steps, 2), toText(forecast.frameSeconds(), 2),
                    solver.description()));
}

} // namespace fpm
