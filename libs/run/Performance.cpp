#include "run/Performance.h"

#include "base/Format.h"
#include "base/Hash.h"
#include "case/PerformanceRecord.h"
#include "run/RunForecast.h"
#include "run/StepBytes.h"
#include "run/StepSetters.h"
#include "run/TimeLoop.h"
#include "solver/contact/Penalties.h"
#include "solver/elements/ElementStep.h"

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
    std::array<Point, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = nodes.at(0, std::size_t(model.mesh.hexahedra[std::size_t(element)][i]));
    return stableStep(model.parts[std::size_t(model.mesh.partOf(element))], corners,
                      solver.elements().setUp().massOf(element));
}

/// Names of the pairs a contact node belongs to.
std::string pairsOf(const Solver& solver, const Model& model, Index node)
{
    std::string names;
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number) {
        const bool here = std::any_of(
            solver.contact().setUp().passes.begin(), solver.contact().setUp().passes.end(),
            [&](const ContactPassSetup& pass) {
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
double largestStiffnessOf(const Solver& solver, std::size_t pair)
{
    double most = 0;
    for (const ContactPassSetup& pass : solver.contact().setUp().passes)
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
    const NodeValues nodes = solver.nodes().values({});
    const std::vector<bool> deleted = solver.elements().values().deleted;
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
    if (solver.elements().setUp().scaled == 0) return;
    double own = 0, scaled = 0;
    for (std::size_t i = 0; i < solver.nodes().setUp().mass.size(); ++i) {
        own += solver.nodes().setUp().ownMass[i];
        scaled += solver.nodes().setUp().mass[i];
    }
    log.line(format("mass scaling: {} added to {} ({} %), {} of {} elements",
                    toText(scaled - own, 5), toText(own, 5), toText(100 * (scaled / own - 1), 5),
                    solver.elements().setUp().scaled, solver.elements().setUp().count));
}

std::string stepLimit(Solver& solver, const Model& model)
{
    const StepClock clock = solver.clock();
    if (model.control.fixedTimeStep > 0) return "timeStep.fixed";
    if (model.control.maximumTimeStep > 0 && clock.step >= model.control.maximumTimeStep)
        return "timeStep.maximum";
    if (!contactBoundsStep(clock, model.control)) return worstElement(solver, model);
    const ContactBound limit = solver.contact().bound();
    if (limit.part >= 0)
        return format("contact springs on rigidFree part {}, omega {}",
                      model.parts[std::size_t(limit.part)].name, limit.frequency);
    if (limit.node < 0) return worstElement(solver, model);
    const Point at = solver.nodes().values({limit.node}).at(0, 0);
    return format("contact pair {}: node {} at ({} {} {}), omega {}",
                  pairsOf(solver, model, limit.node), limit.node, at[0], at[1], at[2],
                  limit.frequency);
}

void reportPairs(Solver& solver, const Model& model, Log& log)
{
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number) {
        const ContactPair& pair = model.contactPairs[number];
        const PairForce now = solver.contact().force(number);
        std::string line = format("pair {}: {} in contact, ", pair.name, now.active);
        line += pair.hasSprings() ? format("springs up to {}, held {}",
                                           largestStiffnessOf(solver, number), now.springEnergy)
                                  : "met exactly";
        if (pair.friction > 0) line += format(", lost to friction {}", now.friction);
        if (!pair.hasSprings() || pair.normalDamping > 0)
            line += format(", lost to contact damping {}", now.damping);
        log.line(line);
    }
}

namespace {

const char* precisionName(Precision precision)
{
    return precision == Precision::double_ ? "double"
           : precision == Precision::mixed ? "mixed"
                                           : "single";
}

/// Friction of each pair, and the pair and node whose springs bounded the last step.
void addContact(PerformanceRecord& record, Solver& solver, const Model& model)
{
    for (std::size_t number = 0; number < model.contactPairs.size(); ++number)
        if (model.contactPairs[number].friction > 0)
            record.frictionWork.emplace_back(model.contactPairs[number].name,
                                             solver.contact().force(number).friction);
    const StepClock clock = solver.clock();
    const bool given = model.control.fixedTimeStep > 0 || model.control.maximumTimeStep > 0;
    if (!given && clock.elementStep > 0 && contactBoundsStep(clock, model.control))
        record.contactLimitedBy = stepLimit(solver, model);
}

PerformanceRecord performanceOf(Solver& solver, const Model& model, const EarlierParts& earlier)
{
    PerformanceRecord record;
    const StepTimes& t = solver.times();
    const StepClock clock = solver.clock();
    record.backend = model.control.backend;
    record.precision = precisionName(model.control.precision);
    record.algorithm = model.control.paperAlgorithm ? "paper" : "default";
    record.description = solver.description();
    record.elements = std::int64_t(model.mesh.hexahedra.size());
    record.nodes = std::int64_t(model.mesh.points.size());
    record.contactors = std::int64_t(contactors(model));
    record.steps = clock.steps;
    record.searches = t.searches;
    record.deviceBytes = std::int64_t(solver.fields().bytes());
    record.wallSeconds = earlier.stepSeconds + t.total;
    record.parts = earlier.count + 1;
    record.partSteps = t.steps;
    record.partSeconds = t.total;
    record.threads = t.threads;
    const double steps = double(t.steps), elements = double(record.elements),
                 touching = double(record.contactors), contact = t.contact + t.search;
    const bool known = t.element > 0;
    const auto over = [](double part, double whole, bool given) {
        return given && whole > 0 ? std::optional(part / whole) : std::nullopt;
    };
    record.nsPerElementStep = over(1e9 * t.total, steps * elements, true);
    record.nsPerContactorStep = over(1e9 * contact, steps * touching, known);
    record.contactShare = over(contact, t.total, known);
    record.bytesPerElementStep =
        over(double(bytesOfStep(solver, model.control.precision)), elements, true);
    record.time = clock.time;
    record.lastStep = clock.step;
    record.elementStep = clock.elementStep;
    addContact(record, solver, model);
    return record;
}

} // namespace

void EarlierParts::keep(Archive& archive)
{
    archive(count);
    archive(stepSeconds);
}

void reportPerformance(Solver& solver,
                       const Model& model,
                       const EarlierParts& earlier,
                       const OutputFolder& theCase,
                       const std::string& runId,
                       Log& log)
{
    const StepTimes t = solver.times();
    const std::int64_t steps = t.steps;
    const std::size_t elements = model.mesh.hexahedra.size();
    const double perStep = steps > 0 ? 1e9 * t.total / (double(steps) * double(elements)) : 0;
    log.line(format("{} elements, {} contactors, {} steps, {} s: {} ns per element-step ({})",
                    elements, contactors(model), steps, toText(t.total, 4), toText(perStep, 4),
                    solver.description()));
    if (t.threads > 0 && t.threads < threadCount(model.control) - 0.05)
        log.line(format("  {} threads on average: other programs had the other cores",
                        toText(t.threads, 3)));
    if (t.element > 0 && t.total > 0)
        log.line(format("  shares: elements {} %, contact {} % ({} searches), nodes {} %",
                        toText(100 * t.element / t.total, 3),
                        toText(100 * (t.contact + t.search) / t.total, 3), t.searches,
                        toText(100 * t.node / t.total, 3)));
    PerformanceRecord record = performanceOf(solver, model, earlier);
    if (earlier.count > 0)
        log.line(format("  the whole run: {} steps, {} s, in {} parts", record.steps,
                        toText(record.wallSeconds, 4), record.parts));
    record.runId = runId;
    record.checksum = hexText(stateChecksum(solver));
    log.line("stateChecksum = " + record.checksum);
    theCase.write(performanceFile, record.text());
}

namespace {

void reportKernels(const Solver& solver, const Model& model, Log& log)
{
    const auto used = [&](bool here, const std::string& name) {
        log.line((here ? "  needed    " : "  left out  ") + name);
    };
    std::array<bool, Laws::size> laws{};
    std::array<bool, Elements::size> elements{};
    for (const KernelGroup& group : solver.elements().setUp().groups)
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
    used(!solver.nodes().setUp().conditions.empty(), "drives and loads, ledger of nodal works");
    used(model.control.massDamping > 0, "mass damping");
    used(model.control.relaxationTolerance > 0, "dynamic relaxation");
    used(!solver.nodes().setUp().pressureFaceCondition.empty(), "pressures");
    used(!solver.bodies().setUp().bodies.empty(), "free rigid bodies");
    used(solver.elements().setUp().rigidParts, "rigid parts (no element work)");
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

void reportDryRun(Solver& solver,
                  const Model& model,
                  const std::filesystem::path& caseRoot,
                  Log& log)
{
    reportKernels(solver, model, log);
    log.line(format("{} nodes, {} elements in {} patches, {} contactors in {} pairs, {} MB",
                    model.mesh.points.size(), model.mesh.hexahedra.size(),
                    solver.elements().setUp().patches.size(), contactors(model),
                    model.contactPairs.size(), toText(double(solver.fields().bytes()) / 1e6, 3)));
    reportMassScaling(solver, log);
    // A few real steps tell the step size with contact, and what a step costs.
    solver.advance(model.control.endTime, 50);
    const StepClock clock = solver.clock();
    log.line(format("time step {} (elements alone {}, contact omega {})", toText(clock.step, 4),
                    toText(clock.elementStep, 4), toText(clock.contactFrequency, 4)));
    log.line("limited by " + stepLimit(solver, model));
    reportStepSetters(stepSetters(solver, model), log);
    reportContactCost(clock, model.control, log);
    const double step = clock.stableStep > 0 ? steadyStep(clock, model.control) : clock.step;
    const RunForecast forecast = forecastRun(solver, model, caseRoot, step, -1);
    const double aStep = solver.times().total / double(std::max<std::int64_t>(1, clock.steps));
    reportForecast(forecast, aStep, log);
    if (const std::string why = endlessReason(clock, model.control, -1); !why.empty())
        log.warning(why);
    log.line(format("expected time {} s for the steps, {} s for the frames ({})",
                    toText(aStep * forecast.steps, 2), toText(forecast.frameSeconds(), 2),
                    solver.description()));
}

} // namespace fpm
