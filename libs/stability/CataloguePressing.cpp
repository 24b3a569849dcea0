#include "mesh/addBox.h"
#include "stability/CatalogueScenes.h"
#include "stability/SceneTools.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

constexpr double young = 70000;

/// The rod of `roundOverlap` bent into the groove: x along the arc, z away from it.
void bend(Model& model, double radius)
{
    for (Point& p : model.mesh.points) {
        const double angle = 0.6 * p[0], out = p[2] < 1.5 ? 1 - p[2] : 2 - p[2];
        p = {(radius + out) * std::sin(angle), p[1], -(radius + out) * std::cos(angle)};
    }
}

/// F11: a round rod at rest in a round groove of the same radius, their facets unlike: the chords
/// overlap by some ten thousandths of it. Largest speed after a while [mm/s].
Measure roundOverlap(ContactVariant variant)
{
    const double radius = 5;
    Model model;
    addBox(model.mesh, "die", {14, 2, 2}, {-1, 0, 0}, {2, 1, 1});
    addBox(model.mesh, "rod", {10, 2, 4}, {-1, 0, 2}, {2, 1, 1});
    bend(model, radius);
    finishScene(model);
    model.parts = {aluminiumPart("die"), aluminiumPart("rod")};
    const auto onArc = [&](const std::string& part) {
        std::vector<ElementSide> sides;
        for (const ElementSide& side : skin(model.mesh, model.mesh.findPart(part))) {
            const Point c = centre(model.mesh, side), n = normal(model.mesh, side);
            const double r = std::hypot(c[0], c[2]), along = (c[0] * n[0] + c[2] * n[2]) / r;
            if (std::abs(r - radius) < 0.1 && std::abs(along) > 0.9) sides.push_back(side);
        }
        return sides;
    };
    addContact(model, "touch", onArc("rod"), onArc("die")).initialOverlap =
        variant == ContactVariant::paper ? InitialOverlap::report : InitialOverlap::offset;
    const auto solver = startedSolver(asVariant(model, variant));
    if (solver->contact().initialOverlap(0).count == 0) return {HUGE_VAL, {}};
    solver->advance(3e-6, 100000);
    double fastest = 0;
    for (const Point& v : halfStepVelocities(*solver)) fastest = std::max(fastest, lengthOf(v));
    return {fastest, {}};
}

/// F12: a coarse block of one face pressed on a fine one. How deep the worst node of the fine one
/// is, over the depth that the pressure has in the springs, were it the same everywhere.
Measure coarseContactor(ContactVariant variant)
{
    const double load = 2000, width = 2.5;
    Model model;
    addBox(model.mesh, "fine", {12, 12, 2}, {0, 0, -1}, {3, 3, 1});
    addBox(model.mesh, "coarse", {1, 1, 1}, {0.25, 0.25, 0}, {width, width, 1});
    finishScene(model);
    model.parts = {aluminiumPart("fine", 0), aluminiumPart("coarse", 0)};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -0.99; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 0.99; }), {false, false, true},
                  {0, 0, -load}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
    addContact(model, "touch", facing(model.mesh, "coarse", {0, 0, -1}),
               facing(model.mesh, "fine", {0, 0, 1}))
        .passes = variant == ContactVariant::remedy ? 2 : 1;
    model.control.massDamping = 1e6;
    const auto solver = startedSolver(asVariant(model, variant));
    solver->advance(4e-5, 1000000);
    const NodeValues values = solver->nodes().values({});
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Index node : model.contactPairs[0].contactorNodes)
        lowest = std::min(lowest, values.at(0, std::size_t(node))[2]);
    for (const Index node : nodesOf(model.mesh, model.contactPairs[0].targetSides)) {
        const Point p = values.at(0, std::size_t(node));
        if (p[0] > 0.5 && p[0] < 2.5 && p[1] > 0.5 && p[1] < 2.5) highest = std::max(highest, p[2]);
    }
    const double even = load / (width * width) / (young / 3 / 0.5); // p / (K / thickness)
    return {(highest - lowest) / even, {}};
}

/// F13: n x n on 5 x 5 faces under a top that moves down, nu = 0. Largest deviation of the axial
/// stress from its mean.
Measure pressedPatch(Index faces, double scale, ContactVariant variant)
{
    const double depth = 0.005, end = 1e-4;
    Model model;
    addBox(model.mesh, "lower", {5, 5, 3}, {0, 0, -3}, {5, 5, 3});
    addBox(model.mesh, "upper", {faces, faces, 3}, {0, 0, 0}, {5, 5, 3});
    finishScene(model);
    model.parts = {aluminiumPart("lower", 0), aluminiumPart("upper", 0)};
    for (const double side : {-1.0, 1.0})
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::displacement, side < 0 ? "base" : "press",
                      nodesWhere(model.mesh, [&](Point p) { return side * p[2] > 2.99; }),
                      {false, false, true}, {0, 0, side < 0 ? 0 : -depth},
                      {Amplitude::Kind::smooth, {{0, 0}, {0.5 * end, 1}}}));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .normalScale = scale;
    model.control.massDamping = 5e5;
    const auto solver = startedSolver(asVariant(model, variant));
    solver->advance(end, 1000000);
    const std::vector<double> stress = solver->elements().values().stress;
    double mean = 0, worst = 0;
    const std::size_t count = stress.size() / 6;
    for (std::size_t e = 0; e < count; ++e) mean += stress[6 * e + 2] / double(count);
    for (std::size_t e = 0; e < count; ++e)
        worst = std::max(worst, std::abs(stress[6 * e + 2] / mean - 1));
    return {mean < 0 ? worst : HUGE_VAL, {}};
}

/// F16: loose layers of 1 x 1 x 0.5 under a load, nu = 0. The worst error of the shortening against
/// layers and springs in series, of 1, 2, 5 and 10 layers.
Measure layerStack(ContactVariant variant)
{
    const double load = 100, scale = 0.1;
    double worst = 0;
    for (const int layers : {1, 2, 5, 10}) {
        Model model;
        const auto name = [](int i) { return "layer" + std::to_string(i); };
        for (int i = 0; i < layers; ++i) {
            addBox(model.mesh, name(i), {1, 1, 2}, {0, 0, 0.5 * i}, {1, 1, 0.5});
            model.parts.push_back(aluminiumPart(name(i), 0));
        }
        finishScene(model);
        for (int i = 1; i < layers; ++i)
            addContact(model, name(i), facing(model.mesh, name(i), {0, 0, -1}),
                       facing(model.mesh, name(i - 1), {0, 0, 1}))
                .normalScale = scale;
        holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < 1e-9; }));
        const std::vector<Index> top =
            nodesWhere(model.mesh, [&](Point p) { return p[2] > 0.5 * layers - 1e-9; });
        model.boundaryConditions.push_back(
            condition(BoundaryCondition::Kind::force, "load", top, {false, false, true},
                      {0, 0, -load}, {Amplitude::Kind::smooth, {{0, 0}, {2e-5, 1}}}));
        model.control.massDamping = 4e5;
        const auto solver = startedSolver(asVariant(model, variant));
        solver->advance(2.5e-4, 1000000);
        const NodeValues values = solver->nodes().values(top);
        double shorter = 0;
        for (std::size_t i = 0; i < top.size(); ++i)
            shorter += (0.5 * layers - values.at(0, i)[2]) / double(top.size());
        // Logarithmic strain; four springs s K A^2 / V a joint, K = E / 3, elements 0.25 high.
        const double exact = 0.5 * layers * (1 - std::exp(-load / young))
                             + (layers - 1) * load / (4 * scale * young / 3 / 0.25);
        worst = std::max(worst, std::abs(shorter / exact - 1));
    }
    return {worst, {}};
}

/// F18: two blocks of unlike meshes pressed together slowly. Root mean square of the force against
/// displacement about its value at rest, after the first tenth.
Measure slowPressing(ContactVariant variant)
{
    const double end = 4e-4, depth = 0.01;
    Model model;
    addBox(model.mesh, "lower", {5, 5, 2}, {0, 0, -3}, {5, 5, 3});
    addBox(model.mesh, "upper", {7, 7, 2}, {0, 0, 0}, {5, 5, 3});
    finishScene(model);
    model.parts = {aluminiumPart("lower", 0), aluminiumPart("upper", 0)};
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -2.99; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::displacement, "press",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 2.99; }), {true, true, true},
                  {0, 0, -depth}, {Amplitude::Kind::smooth, {{0, 0}, {end, 1}}}));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}));
    const auto solver = startedSolver(asVariant(model, variant));
    const Amplitude amplitude = model.boundaryConditions.back().amplitude;
    std::vector<double> ratios;
    while (solver->clock().time < end) {
        solver->advance(end, 20);
        const double travel = depth * amplitude(solver->clock().time);
        if (travel > 0.1 * depth) ratios.push_back(solver->contact().force(0).force[2] / travel);
    }
    double squares = 0;
    for (const double ratio : ratios) squares += std::pow(ratio / ratios.back() - 1, 2);
    return {std::sqrt(squares / double(ratios.size())), {}};
}

} // namespace

std::vector<Failure> pressingFailures()
{
    return {
        {.number = 11,
         .name = "roundOverlap",
         .fails = "Facets of curved bodies overlap at the start and are shot apart.",
         .quantity = "largest speed of two bodies at rest [mm/s]",
         .limit = 0,
         .reason = "nothing moves them",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "initialOverlap offset, the default (or ramp, or move)",
         .note = "algorithm paper with initialOverlap report, which pushes them out",
         .run = roundOverlap},
        {.number = 12,
         .name = "coarseContactor",
         .fails = "Nodes of a fine target sink in between those of a coarse contactor.",
         .quantity = "depth of the worst target node over that of even pressure in the springs",
         .limit = 2,
         .reason = "even pressure, borne by one of two passes with half the stiffness",
         .expected = {Fate::loses, Fate::loses, Fate::holds},
         .remedy = "passes two, or the finer side as contactor",
         .note = "one pass does not see target nodes",
         .run = coarseContactor},
        {.number = 13,
         .name = "pressedPatch",
         .fails = "Even pressure does not pass evenly through unlike meshes (patch test).",
         .quantity = "largest deviation of the stress from its mean, hard springs",
         .limit = 0.01,
         .reason = "the exact stress is even",
         .expected = {Fate::loses, Fate::loses, Fate::holds},
         .remedy = "matching meshes",
         .note = "a property of node-to-face contact, here of 7 x 7 on 5 x 5 faces",
         .run =
             [](ContactVariant variant) {
                 return pressedPatch(variant == ContactVariant::remedy ? 5 : 7, 100, variant);
             }},
        {.number = 13,
         .name = "softPatch",
         .fails = "Nodes on the rim of a body have whole springs for half and quarter areas.",
         .quantity = "largest deviation of the stress from its mean, matching meshes",
         .limit = 0.01,
         .reason = "the exact stress is even",
         .expected = {Fate::loses, Fate::loses, Fate::holds},
         .remedy = "harder springs, normalScale 100",
         .note = "every contactor has the stiffness of a face, whatever its share of the area: the "
                 "softer the springs, the more the rim bears",
         .run =
             [](ContactVariant variant) {
                 return pressedPatch(5, variant == ContactVariant::remedy ? 100 : 1, variant);
             }},
        {.number = 16,
         .name = "layerStack",
         .fails = "Soft springs of many layers add up to a wrong thickness and stiffness.",
         .quantity = "error of the shortening, 1 to 10 layers",
         .limit = 0.01,
         .reason = "layers and springs in series",
         .remedy = "the springs' share is known before the run: s_n by wanted depth",
         .run = layerStack},
        {.number = 18,
         .name = "slowPressing",
         .fails = "Nodes alternate in and out and the force is noisy.",
         .quantity = "root mean square of force against displacement about its rest",
         .limit = 0.01,
         .reason = "elastic bodies pressed slowly: force follows displacement",
         .remedy = "none needed; contact damping exists",
         .run = slowPressing},
    };
}

} // namespace fpm
