#include "mesh/addBox.h"
#include "stability/CatalogueScenes.h"
#include "stability/Scene.h"
#include "stability/SceneTools.h"
#include "stability/TrialRun.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

double waveSpeed(const Part& part)
{
    const double nu = part.poissonsRatio;
    return std::sqrt(part.youngsModulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / part.density);
}

/// Whether a rigid brick led down into a block at `speed` times the speed of its waves has all of
/// its four nodes in contact before it has gone through, from `start` above it.
bool isCaught(double speed, double start, ContactVariant variant)
{
    Model model;
    addBox(model.mesh, "block", {3, 3, 3}, {-1, -1, -3}, {3, 3, 3});
    addBox(model.mesh, "brick", {1, 1, 1}, {0.1, 0.1, start}, {0.8, 0.8, 1});
    finishScene(model);
    model.parts = {aluminiumPart("block"), aluminiumPart("brick")};
    model.parts[1].kind = PartKind::rigidPrescribed;
    const std::vector<Index> brick = nodesOfPart(model.mesh, "brick");
    const double fall = speed * waveSpeed(model.parts[0]);
    throwPart(model, "brick", {0, 0, -fall});
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "led", brick,
                                                 {true, true, true}, {0, 0, -fall}));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -2.99; }));
    addContact(model, "touch", facing(model.mesh, "brick", {0, 0, -1}),
               facing(model.mesh, "block", {0, 0, 1}));
    const auto solver = startedSolver(asVariant(model, variant));
    while (solver->clock().time * fall < start + 1.5 && !solver->clock().failed) {
        solver->advance(1, 1);
        if (solver->contact().force(0).active == 4) return true;
    }
    return false;
}

/// F8: the first speed at which nodes pass, over that of waves.
Measure fastBrick(ContactVariant variant)
{
    constexpr double fastest = 2;
    for (double speed = 0.1; speed < fastest; speed += 0.1)
        for (double start = 0.3; start < 0.9; start += 0.07)
            if (!isCaught(speed, start, variant)) return {speed, {}};
    return {fastest, {}};
}

/// F9: layers a tenth as thick as an element is wide, struck by a block at 200 m/s. Deepest mean
/// overlap of two neighbours over the thickness; 2 where a node was released or the run failed.
Measure thinLayers(ContactVariant variant)
{
    constexpr double thickness = 0.05;
    Model model;
    std::vector<std::string> order{"ground", "layer1", "layer2", "layer3", "stamp"};
    addBox(model.mesh, "ground", {4, 4, 1}, {0, 0, -0.5}, {2, 2, 0.5});
    for (int i = 1; i <= 3; ++i)
        addBox(model.mesh, order[std::size_t(i)], {4, 4, 1}, {0, 0, thickness * (i - 1)},
               {2, 2, thickness});
    addBox(model.mesh, "stamp", {2, 2, 1}, {0.5, 0.5, 3 * thickness}, {1, 1, 0.5});
    finishScene(model);
    for (const std::string& name : order) model.parts.push_back(aluminiumPart(name));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -0.49; }));
    throwPart(model, "stamp", {0, 0, -2e5});
    for (std::size_t i = 1; i < order.size(); ++i)
        addContact(model, order[i], facing(model.mesh, order[i], {0, 0, -1}),
                   facing(model.mesh, order[i - 1], {0, 0, 1}));
    const auto solver = startedSolver(asVariant(model, variant));
    double deepest = 0;
    while (solver->clock().time < 4e-6 && !solver->clock().failed) {
        solver->advance(4e-6, 50);
        for (std::size_t i = 1; i < order.size(); ++i) {
            const PairForce now = solver->contact().force(i - 1);
            if (now.released > 0) return {2, {}};
            const double force = now.force[2]; // depth weighted by force: 2 E / F
            if (force > 0) deepest = std::max(deepest, 2 * now.springEnergy / force / thickness);
        }
    }
    return {solver->clock().failed ? 2 : deepest, {}};
}

/// F14: a cube thrown along the diagonal into the corner of three loose walls. Least ratio along an
/// axis of the momentum returned to that before the impact, 0 where the balance is off by 1 %.
Measure cornerOfWalls(ContactVariant variant)
{
    Model model;
    addBox(model.mesh, "floor", {3, 3, 1}, {0, 0, -1}, {3, 3, 1});
    addBox(model.mesh, "left", {1, 3, 3}, {-1, 0, 0}, {1, 3, 3});
    addBox(model.mesh, "back", {3, 1, 3}, {0, -1, 0}, {3, 1, 3});
    addBox(model.mesh, "cube", {2, 2, 2}, {0.02, 0.02, 0.02}, {1, 1, 1});
    finishScene(model);
    for (const char* name : {"floor", "left", "back", "cube"})
        model.parts.push_back(aluminiumPart(name));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) {
                  return p[0] < -0.99 || p[1] < -0.99 || p[2] < -0.99;
              }));
    throwPart(model, "cube", {-4e4, -4e4, -4e4});
    const std::array<std::string, 3> walls{"left", "back", "floor"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Point out{0, 0, 0}, in{0, 0, 0};
        out[axis] = -1;
        in[axis] = 1;
        addContact(model, walls[axis], facing(model.mesh, "cube", out),
                   facing(model.mesh, walls[axis], in));
    }
    const auto solver = startedSolver(asVariant(model, variant));
    const std::vector<Index> cube = nodesOfPart(model.mesh, "cube");
    const double before = momentum(*solver, cube)[0];
    solver->advance(3e-6, 100000);
    const Point after = momentum(*solver, cube);
    if (!(std::abs(solver->ledger().energies().balance) < 0.01)) return {0, {}};
    return {-std::max({after[0], after[1], after[2]}) / before, {}};
}

/// F17: two bars meet end to end at 0.6 of the step of their elements, springs ever harder. First
/// penalty scale at which the run diverges, over the largest that the bound of elements and
/// springs allows.
Measure penaltySweep(ContactVariant variant)
{
    constexpr double step = 0.6;
    const auto trialAt = [&](double penalty, Setting& setting) {
        setting.set(parameter::penalty, penalty);
        setting.set(parameter::timeStep, step);
        Trial trial = probeScenes().front().make(setting);
        applyCommon(trial.model, setting);
        trial.model = asVariant(trial.model, variant);
        return trial;
    };
    double low = 1e-3, high = 1e3;
    while (high / low > 1.001) {
        const double middle = std::sqrt(low * high);
        Setting setting;
        const bool allowed = step <= boundsOf(trialAt(middle, setting).model).withContact;
        (allowed ? low : high) = middle;
    }
    for (double ratio = 0.5; ratio < 20; ratio *= 1.1) {
        Setting setting;
        const Trial trial = trialAt(ratio * low, setting);
        const TrialResult result =
            runTrial(trial, setting, boundsOf(trial.model), TrialLimits{.steps = 200});
        if (result.outcome == Outcome::diverged) return {ratio, {}};
    }
    return {20, {}};
}

/// Two free blocks of unlike meshes, the upper one thrown askew on the lower one.
Model freeBlocks(double friction)
{
    Model model;
    addBox(model.mesh, "lower", {8, 7, 4}, {-2, -2, -4}, {12, 11, 4});
    addBox(model.mesh, "upper", {5, 4, 5}, {1.4, 1.5, 0}, {6, 5, 6});
    finishScene(model, 32);
    model.parts = {aluminiumPart("lower"), aluminiumPart("upper")};
    throwPart(model, "upper", {3e4, -2e4, -6e4});
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .friction = friction;
    return model;
}

/// Largest change of a momentum of all nodes over its size.
Measure momentumChange(const Model& model, const std::function<Point(Solver&)>& momentumOf)
{
    const auto solver = startedSolver(model);
    const Point before = momentumOf(*solver);
    double worst = 0, strongest = 0;
    for (int sample = 0; sample < 50; ++sample) {
        solver->advance(1, 5);
        const Point after = momentumOf(*solver);
        worst = std::max(
            worst, lengthOf({after[0] - before[0], after[1] - before[1], after[2] - before[2]}));
        strongest = std::max(strongest, solver->contact().force(0).force[2]);
    }
    return {strongest > 0 ? worst / lengthOf(before) : 1, {}};
}

/// F27: the same impact on one thread and on three; number of states that differ.
Measure repeatedRun(ContactVariant variant)
{
    Model model = asVariant(freeBlocks(0.3), variant);
    std::vector<std::uint64_t> sums;
    for (const int threads : {1, 3, 3}) {
        model.control.backend = "openmp";
        model.control.threads = threads;
        const auto solver = startedSolver(model);
        solver->advance(1, 60);
        const bool touches = solver->contact().force(0).force[2] > 0;
        solver->advance(1, 140);
        sums.push_back(touches ? stateChecksum(*solver) : 0);
    }
    double differ = 0;
    for (const std::uint64_t sum : sums) differ += sum != sums[0] || sum == 0;
    return {differ, {}};
}

} // namespace

std::vector<Failure> impactFailures()
{
    return {
        {.number = 8,
         .name = "fastBrick",
         .fails = "A step carries a node through the target before it is seen.",
         .quantity = "first speed that is lost, over that of waves",
         .limit = 1,
         .atLeast = true,
         .reason = "a step no longer than a wave takes through an element",
         .remedy = "the step bounds the displacement; lists are rebuilt before they become invalid",
         .note = "both search in time; what fails first is the depth at which a node is found",
         .run = fastBrick},
        {.number = 9,
         .name = "thinLayers",
         .fails = "A node passes the middle of a thin layer and is pushed out on its other side.",
         .quantity = "deepest mean overlap over the thickness",
         .limit = 0.5,
         .reason = "half a layer: beyond it the other side is nearer",
         .remedy = "pairs have defined sides; nodes are tracked, not searched again",
         .run = thinLayers},
        {.number = 14,
         .name = "cornerOfWalls",
         .fails = "In a concave corner one wall is chosen and the others are violated.",
         .quantity = "momentum returned along the worst axis",
         .limit = 0.5,
         .atLeast = true,
         .reason = "elastic walls give back most; a violated one nothing",
         .remedy = "one pair a wall, or general contact",
         .note = "one body as all three walls: ContactScenes and SignedGap tests",
         .run = cornerOfWalls},
        {.number = 17,
         .name = "penaltySweep",
         .fails = "Hard springs make the step unstable.",
         .quantity = "first penalty that diverges over the largest the bound allows",
         .limit = 1,
         .atLeast = true,
         .reason = "2 / sqrt(omega_e^2 + omega_c^2) is a bound",
         .remedy = "the automatic step counts the springs",
         .note = "so much is the bound on the safe side",
         .run = penaltySweep},
        {.number = 22,
         .name = "freeImpact",
         .fails = "The reaction on the target is not that on the contactor.",
         .quantity = "change of the linear momentum over itself",
         .limit = 1e-12,
         .reason = "conservation",
         .remedy = "the contactor's force is minus the exact sum of its face's",
         .run =
             [](ContactVariant variant) {
                 return momentumChange(asVariant(freeBlocks(0.3), variant),
                                       [](Solver& solver) { return momentum(solver); });
             }},
        {.number = 22,
         .name = "obliqueImpact",
         .fails = "Force and reaction do not act along one line.",
         .quantity = "change of the angular momentum over itself, with friction",
         .limit = 1e-11,
         .reason = "conservation",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "the force acts along the line to the projection point; a couple on the face "
                   "balances friction",
         .note = "eqs. 17-18 as printed leave the moment friction times gap",
         .run =
             [](ContactVariant variant) {
                 return momentumChange(asVariant(freeBlocks(0.3), variant), angularMomentum);
             }},
        {.number = 27,
         .name = "repeatedRun",
         .fails = "Sums in the order of threads give every run other numbers.",
         .quantity = "runs of three on one and more threads whose state differs",
         .limit = 0,
         .reason = "equal bits",
         .remedy = "forces are summed as integers",
         .run = repeatedRun},
    };
}

} // namespace fpm
