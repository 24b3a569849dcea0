#include "mesh/addBox.h"
#include "stability/CatalogueScenes.h"
#include "stability/SceneTools.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// A unit block led over a fixed row of faces of half its size: what contact does then is geometry
/// alone. `shape`: where a node of the track lies that would be at this x in a flat one.
Model slider(const std::function<Point(double)>& shape,
             double start,
             double height,
             Point velocity,
             double width = 0.77)
{
    Model model;
    addBox(model.mesh, "track", {24, 4, 1}, {0, -0.5, -0.5}, {12, 2, 0.5});
    addBox(model.mesh, "block", {1, 1, 1}, {start, 0, height}, {1, width, 1});
    for (const Index node : nodesOfPart(model.mesh, "track")) {
        Point& p = model.mesh.points[std::size_t(node)];
        const Point to = shape(p[0]);
        p = {to[0], p[1], p[2] + to[2]};
    }
    finishScene(model);
    model.parts = {aluminiumPart("track"), aluminiumPart("block")};
    holdFixed(model, nodesOfPart(model.mesh, "track"));
    throwPart(model, "block", velocity);
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "led",
                                                 nodesOfPart(model.mesh, "block"),
                                                 {true, true, true}, velocity));
    addContact(model, "touch", facing(model.mesh, "block", {0, 0, -1}),
               facing(model.mesh, "track", {0, 0, 1}));
    model.control.fixedTimeStep = 2e-8;
    return model;
}

Point flat(double x)
{
    return {x, 0, 0};
}

/// Largest change of the force between samples, over the force, until the block has moved by
/// `variant`.
Measure worstJerk(const Model& model, double distance)
{
    const auto solver = startedSolver(model);
    const double speed = model.initialVelocities[0].velocity[0];
    double last = solver->contact().force(0).force[2], worst = last > 0 ? 0 : 1;
    while (speed * solver->clock().time < distance) {
        solver->advance(1, 1);
        const double now = solver->contact().force(0).force[2];
        worst = std::max(worst, std::abs(now / last - 1));
        last = now;
    }
    return {worst, {}};
}

/// F5: nodes go along edges of faces and over their corners.
Measure nodesOnEdges(ContactVariant variant)
{
    return worstJerk(asVariant(slider(flat, 0.3, -0.01, {1e6, 0, 0}, 1), variant), 10);
}

/// F7: each face of the track is a tenth longer than the one before.
Measure gradedFaces(ContactVariant variant)
{
    const auto graded = [](double x) {
        return Point{12 * (std::pow(1.1, 2 * x) - 1) / (std::pow(1.1, 24) - 1), 0, 0};
    };
    return worstJerk(asVariant(slider(graded, 0.3, -0.01, {1e6, 0, 0}), variant), 10);
}

/// F6: led over a ridge of twice 22 degrees, 0.2 below its top. Error of the energy over that of
/// the springs, in units of what the step in which the normal turns may cause: the force changes by
/// 0.8 k g along its displacement, over k g^2 / 2.
Measure kinkedTrack(double friction, ContactVariant variant)
{
    const double depth = 0.2, step = 2e-8, speed = 2e5;
    Model model = slider(
        [](double x) {
            return Point{x, 0, -0.4 * std::abs(x - 6)};
        },
        5.4, -depth, {speed, 0, 0});
    model.contactPairs[0].friction = friction;
    model.control.fixedTimeStep = step;
    const auto solver = startedSolver(asVariant(model, variant));
    const double start = solver->ledger().energies().total;
    double worst = 0, most = 0;
    while (solver->clock().time < 8e-6) {
        solver->advance(8e-6, 10);
        const Energies now = solver->ledger().energies();
        worst = std::max(worst, std::abs(now.total - now.external - start));
        most = std::max(most, now.contact);
    }
    return {worst / most / (0.8 * speed * step / depth), {}};
}

/// F15: off the end of the track at x = 12. Distance beyond it at which a node is still in contact,
/// over the width of a face; 1 where a node is released before the end or the force is not that of
/// the nodes in contact.
Measure tableEdge(ContactVariant variant)
{
    const double speed = 1e5;
    const auto solver =
        startedSolver(asVariant(slider(flat, 10.6, -0.001, {speed, 0, 0}), variant));
    const double each = solver->contact().force(0).force[2] / 4;
    double farthest = 0;
    for (double front = 11.6; front < 13.2; front = 11.6 + speed * solver->clock().time) {
        const PairForce now = solver->contact().force(0);
        const int on = (front < 12 ? 2 : 0) + (front < 13 ? 2 : 0);
        if (now.active < on || std::abs(now.force[2] / each - now.active) > 1e-9) return {1, {}};
        if (now.active > on)
            farthest = std::max(farthest, (front - (now.active > 2 ? 12 : 13)) / 0.5);
        solver->advance(1, 1);
    }
    return {farthest, {}};
}

/// Turned about (1 1 1) through the origin.
Point turned(const Point& p, double angle)
{
    const double s = std::sin(angle) / std::sqrt(3.0), k = std::cos(angle);
    const double along = (1 - k) * (p[0] + p[1] + p[2]) / 3;
    return {k * p[0] + s * (p[2] - p[1]) + along, k * p[1] + s * (p[0] - p[2]) + along,
            k * p[2] + s * (p[1] - p[0]) + along};
}

constexpr Point shearSlip{0.008, -0.004, 0};
constexpr double shearTime = 1e-5, turnTime = 4e-4;

/// Two bricks pressed together, the upper one of 1 x 1 sheared by `shearSlip` on faces of `width`
/// and then both turned once round: all nodes are moved as prescribed.
Model turningPair(double width)
{
    Model model;
    const Index cells = width > 1 ? 2 : 1;
    addBox(model.mesh, "lower", {cells, cells, 1}, {-width, -width, -1},
           {cells * width, cells * width, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {width > 1 ? -0.7 : -1, width > 1 ? -0.9 : -1, -0.01},
           {1, 1, 1});
    finishScene(model);
    model.parts = {aluminiumPart("lower", 0), aluminiumPart("upper", 0)};
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .friction = 0.9;
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    for (Index i = 0; i < Index(model.mesh.points.size()); ++i) {
        const Point p = model.mesh.points[std::size_t(i)];
        const double shear = std::binary_search(upper.begin(), upper.end(), i) ? 1 : 0;
        const Point to{p[0] + shear * shearSlip[0], p[1] + shear * shearSlip[1], p[2]};
        for (std::size_t c = 0; c < 3; ++c) {
            Amplitude amplitude{Amplitude::Kind::table, {{0, 0}, {shearTime, to[c] - p[c]}}};
            for (int n = 1; n <= 400; ++n)
                amplitude.rows.push_back(
                    {shearTime + turnTime * n / 400, turned(to, 2 * M_PI * n / 400)[c] - p[c]});
            std::array<bool, 3> driven{false, false, false};
            driven[c] = true;
            Point one{0, 0, 0};
            one[c] = 1;
            model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement,
                                                         "turn", {i}, driven, one, amplitude));
        }
    }
    model.control.fixedTimeStep = 5e-8;
    return model;
}

/// F19: error of the friction force by hand, four springs k_t times the slip, turned with the
/// bodies: the worst of a full turn.
Measure turnedPair(double width, ContactVariant variant)
{
    Model model = turningPair(width);
    const double scale = model.contactPairs[0].tangentialScale = 0.1; // so that friction bears it
    const auto solver = startedSolver(asVariant(model, variant));
    const double spring = 4 * scale * 70000.0 / 3 * width * width; // K A^2 / V, K = E / 3
    double worst = 0;
    for (int part = 0; part <= 8; ++part) {
        solver->advance(shearTime + turnTime * part / 8, 1000000);
        const Point now = turned(solver->contact().force(0).force, -2 * M_PI * part / 8);
        const Point error{now[0] + spring * shearSlip[0], now[1] + spring * shearSlip[1], 0};
        worst = std::max(worst, lengthOf(error) / (spring * lengthOf(shearSlip)));
    }
    return {worst, {}};
}

/// F20: a brick on another, loaded by its weight and by less along the joint than friction bears.
/// Error of the slip against k_t at two late times, the worse. `width`: of the lower brick under
/// the upper one of 1; equal ones have the nodes of their sides on the rim.
Measure restingSlip(double width, ContactVariant variant)
{
    const double weight = 100, along = 20;
    Model model;
    addBox(model.mesh, "lower", {1, 1, 1}, {(1 - width) / 2, (1 - width) / 2, -1},
           {width, width, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {0, 0, 0}, {1, 1, 1});
    finishScene(model);
    model.parts = {aluminiumPart("lower", 0), aluminiumPart("upper", 0)};
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = 0.3;
    holdFixed(model, nodesOfPart(model.mesh, "lower"));
    const std::vector<Index> base = pair.contactorNodes;
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::force, "weight", base,
                                                 {false, false, true}, {0, 0, -weight},
                                                 {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "along", base, {true, false, false},
                  {along, 0, 0}, {Amplitude::Kind::smooth, {{2e-5, 0}, {6e-5, 1}}}));
    model.control.massDamping = 1e6;
    const double spring = 4 * pair.tangentialScale * 70000.0 / 3 * width * width; // K A^2 / V
    const auto solver = startedSolver(asVariant(model, variant));
    double worst = 0;
    for (const double time : {2e-4, 1e-3}) {
        solver->advance(time, 1000000);
        const NodeValues values = solver->nodes().values(base);
        double slip = 0;
        for (std::size_t i = 0; i < base.size(); ++i)
            slip += (values.at(0, i)[0] - model.mesh.points[std::size_t(base[i])][0]) / 4;
        worst = std::max(worst, std::abs(slip / (along / spring) - 1));
    }
    return {worst, {}};
}

/// F21: a block pressed with changing force and sheared to and fro beyond sticking. Worst error of
/// the balance, or the share of the friction work that was returned.
Measure cyclicShear(ContactVariant variant)
{
    Model model;
    addBox(model.mesh, "lower", {3, 3, 1}, {-1, -1, -1}, {3, 3, 1});
    addBox(model.mesh, "upper", {2, 2, 1}, {-0.3, -0.4, -0.01}, {1.5, 1.5, 1});
    finishScene(model);
    model.parts = {aluminiumPart("lower"), aluminiumPart("upper")};
    holdFixed(model, nodesOfPart(model.mesh, "lower"));
    Amplitude along{Amplitude::Kind::table, {{0, 0}}}, down = along;
    for (int n = 1; n <= 400; ++n) {
        along.rows.push_back({n * 1e-7, 0.02 * std::sin(0.05 * n)});
        down.rows.push_back({n * 1e-7, -0.008 * std::sin(0.13 * n)});
    }
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement, "along",
                                                 upper, {true, true, false}, {1, 0.5, 0}, along));
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement, "down",
                                                 upper, {false, false, true}, {0, 0, 1}, down));
    addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
               facing(model.mesh, "lower", {0, 0, 1}))
        .friction = 0.3;
    model.control.fixedTimeStep = 5e-9;
    const auto solver = startedSolver(asVariant(model, variant));
    double last = 0, back = 0, worst = 0;
    while (solver->clock().time < 4e-5) {
        solver->advance(4e-5, 20);
        const double lost = solver->ledger().energies().friction;
        back = std::max(back, last - lost);
        last = lost;
        worst = std::max(worst, std::abs(solver->ledger().energies().balance));
    }
    return {last > 0 ? std::max(worst, back / last) : 1, {}};
}

} // namespace

std::vector<Failure> slidingFailures()
{
    const std::string constant = "a plane is a plane: the force is constant but for rounding";
    return {
        {.number = 5,
         .name = "nodesOnEdges",
         .fails = "Rounding decides whether a node over a border of faces is in contact.",
         .quantity = "largest change of the force in a step",
         .limit = 1e-9,
         .reason = constant,
         .remedy = "clamped closest points, a margin at free edges",
         .note = "algorithm paper clamps as the default does",
         .run = nodesOnEdges},
        {.number = 6,
         .name = "kinkedTrack",
         .fails = "Where the normal turns at once the force makes energy.",
         .quantity = "error of the energy over what the step of the turn may cost",
         .limit = 1.000001,
         .reason =
             "change of the force times the displacement of that step, exact in the worst phase, "
             "which this is; rounding",
         .remedy = "the force is the gradient of a potential",
         .run = [](ContactVariant variant) { return kinkedTrack(0, variant); }},
        {.number = 6,
         .name = "roughKink",
         .fails = "Where the normal turns at once friction keeps its old direction, or counts slip "
                  "that did not occur.",
         .quantity = "error of the energy over what the step of the turn may cost",
         .limit = 1,
         .reason = "as without friction",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy =
             "the stored force turns with the face; a projection point that jumps makes no slip",
         .note = "eqs. 17-18 as printed do not turn the stored force into the new plane",
         .run = [](ContactVariant variant) { return kinkedTrack(0.3, variant); }},
        {.number = 7,
         .name = "gradedFaces",
         .fails = "The spring jumps where a node meets a face of other stiffness.",
         .quantity = "largest change of the force in a step",
         .limit = 1e-9,
         .reason = constant,
         .remedy = "a closed spring keeps its stiffness",
         .note = "algorithm paper keeps it too; the printed one takes that of each face: 10 % at "
                 "every border here",
         .run = gradedFaces},
        {.number = 15,
         .name = "tableEdge",
         .fails = "A node that has left the target over its end is still held.",
         .quantity = "distance beyond the end over the width of a face",
         .limit = 0.012,
         .reason = "margin of a hundredth, and one step",
         .remedy = "free edges end the surface, but for a margin",
         .note = "algorithm paper ends surfaces as the default does; the printed one does not say "
                 "where",
         .run = tableEdge},
        {.number = 19,
         .name = "turnedPair",
         .fails = "A stuck pair that turns leaves its friction force behind in space.",
         .quantity = "error of the friction force over a full turn",
         .limit = 0.01,
         .reason = "springs k_t by hand; a rigid motion changes no traction",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "the stored force turns with the face",
         .note = "eqs. 17-18 as printed store it in global axes",
         .run = [](ContactVariant variant) { return turnedPair(2, variant); }},
        {.number = 19,
         .name = "turnedAtRim",
         .fails = "The same where nodes lie on the rim of the target, beyond its free edges.",
         .quantity = "error of the friction force over a full turn",
         .limit = 0.01,
         .reason = "springs k_t by hand; a rigid motion changes no traction",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "the displacement beyond the edge is measured in axes of the face",
         .note = "as turnedPair",
         .run = [](ContactVariant variant) { return turnedPair(1, variant); }},
        {.number = 20,
         .name = "restingOnIncline",
         .fails = "A stuck block creeps, or slips further than its springs let it.",
         .quantity = "error of the elastic slip, early and late",
         .limit = 0.01,
         .reason = "load over four springs k_t",
         .remedy = "elastic slip is stored, not rebuilt",
         .run = [](ContactVariant variant) { return restingSlip(3, variant); }},
        {.number = 20,
         .name = "restingAtRim",
         .fails = "The same where nodes lie on the rim of the target.",
         .quantity = "error of the elastic slip, early and late",
         .limit = 0.01,
         .reason = "load over four springs k_t",
         .remedy = "the displacement of a contactor beyond a free edge counts, though its "
                   "projection point stays on it",
         .run = [](ContactVariant variant) { return restingSlip(1, variant); }},
        {.number = 21,
         .name = "cyclicShear",
         .fails = "Friction gives energy back when the pressure changes while it slides.",
         .quantity = "error of the balance, or share of friction work given back",
         .limit = 1e-9,
         .reason = "all motion is imposed: the balance is exact but for rounding",
         .remedy = "friction work is summed from force and slip",
         .run = cyclicShear},
    };
}

} // namespace fpm
