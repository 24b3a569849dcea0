#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

using Kind = BoundaryCondition::Kind;
constexpr double pi = 3.14159265358979323846;

/// Columns: where x, y and z go.
Axes turned(double degrees)
{
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    // About z, then about the new x: no axis stays what it was.
    return {{{c, s, 0}, {-s * c, c * c, s}, {s * s, -c * s, c}}};
}
Point applied(const Axes& axes, const Point& p)
{
    Point out{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t c = 0; c < 3; ++c) out[c] += p[i] * axes[i][c];
    return out;
}

/// Held, driven and loaded in every way, in axes that are turned together with the block.
Model everything(const Axes& axes)
{
    Model model =
        boxModel({3, 2, 2}, {3, 2, 2}, aluminium(PartKind::elastoplastic, HourglassForm::physical));
    const Mesh& mesh = model.mesh;
    const auto at = [&](std::size_t axis, double value) {
        return nodesWhere(mesh, [=](Point p) { return std::abs(p[axis] - value) < 0.01; });
    };
    const Amplitude smooth{Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}};
    auto& all = model.boundaryConditions;
    all.push_back(condition(Kind::fixed, "a", at(0, 0), {true, false, false}));
    all.push_back(condition(Kind::fixed, "b", at(1, 0), {false, true, false}));
    all.push_back(
        condition(Kind::velocity, "c", at(2, 0), {false, false, true}, {0, 0, -500}, smooth));
    all.push_back(
        condition(Kind::displacement, "d", at(0, 3), {true, false, false}, {0.02, 0, 0}, smooth));
    all.push_back(condition(Kind::force, "e", at(1, 2), {true, true, true}, {20, -30, 10}, smooth));
    BoundaryCondition traction =
        condition(Kind::traction, "f", {}, {true, true, true}, {5, 3, -9}, smooth);
    traction.sides = facing(mesh, "box", {0, 0, 1});
    traction.nodes = nodesOf(mesh, traction.sides);
    all.push_back(traction);
    BoundaryCondition pressure = traction;
    pressure.kind = Kind::pressure;
    pressure.value = {40, 0, 0};
    all.push_back(pressure);
    for (BoundaryCondition& one : all) one.axes = axes;
    all.back().axes = globalAxes;
    BoundaryCondition gravity = condition(Kind::gravity, "g", nodesOfPart(mesh, "box"),
                                          {true, true, true}, applied(axes, {1e7, 2e7, -4e7}));
    gravity.parts = {0};
    all.push_back(gravity);
    for (Point& point : model.mesh.points) point = applied(axes, point);
    return model;
}

TEST(LocalAxes, ATurnedSceneGivesTheTurnedResult)
{
    const Axes axes = turned(30);
    const Model straight = everything(globalAxes), oblique = everything(axes);
    const auto a = startedSolver(straight, true), b = startedSolver(oblique, true);
    a->advance(1.5e-5, 100000);
    b->advance(1.5e-5, 100000);
    EXPECT_GT(a->ledger().energies().plastic, 0);
    const NodeValues x = a->nodes().values({}), y = b->nodes().values({});
    double most = 0;
    for (std::size_t i = 0; i < x.count; ++i) {
        const Point wanted = applied(axes, x.at(0, i)), force = applied(axes, x.at(3, i));
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(y.at(0, i)[c], wanted[c], 1e-10);
            EXPECT_NEAR(y.at(3, i)[c], force[c], 1e-6);
            most = std::max(most, std::abs(x.at(0, i)[c] - straight.mesh.points[i][c]));
        }
    }
    EXPECT_GT(most, 0.01);
    const NodalWorks v = a->ledger().nodalWorks(), w = b->ledger().nodalWorks();
    EXPECT_NEAR(w.drives, v.drives, 1e-9 * std::abs(v.drives));
    EXPECT_NEAR(w.external, v.external, 1e-9 * std::abs(v.external));
    EXPECT_NEAR(b->ledger().energies().kinetic, a->ledger().energies().kinetic,
                1e-9 * a->ledger().energies().kinetic);
}

TEST(LocalAxes, ADrivenDirectionIsTrackedExactly)
{
    const Axes axes = turned(30);
    const Model model = everything(axes);
    const auto solver = startedSolver(model);
    const BoundaryCondition& pull = model.boundaryConditions[3];
    for (int call = 0; call < 20; ++call) {
        solver->advance(1.5e-5, 5);
        const double wanted = 0.02 * pull.amplitude(solver->clock().time);
        const NodeValues values = solver->nodes().values(pull.nodes);
        for (std::size_t i = 0; i < values.count; ++i) {
            const Point& start = model.mesh.points[std::size_t(pull.nodes[i])];
            double way = 0;
            for (std::size_t c = 0; c < 3; ++c) way += (values.at(0, i)[c] - start[c]) * axes[0][c];
            EXPECT_NEAR(way, wanted, 1e-14);
        }
    }
}

TEST(LocalAxes, NodesOfTwoMirrorPlanesMoveAlongTheirEdge)
{
    // A wedge of 60 degrees between the planes y = 0 and y = sqrt(3) x.
    Model model =
        boxModel({3, 3, 2}, {2, 1, 2}, aluminium(PartKind::elastic, HourglassForm::physical));
    const double root = std::sqrt(3.0);
    const auto first = nodesWhere(model.mesh, [](Point p) { return p[1] < 1e-9; });
    const auto second = nodesWhere(model.mesh, [](Point p) { return p[1] > 1 - 1e-9; });
    for (Point& p : model.mesh.points) { // polar: radius 1..3, angle 0..60 degrees
        const double r = 1 + p[0], angle = p[1] * pi / 3;
        p = {r * std::cos(angle), r * std::sin(angle), p[2]};
    }
    // One edge more, as if the inner radius were 0: its nodes are held by both.
    std::vector<Index> edge;
    for (const Index node : first)
        if (model.mesh.points[std::size_t(node)][0] < 1.01) edge.push_back(node);
    std::vector<Index> both = second;
    both.insert(both.end(), edge.begin(), edge.end());
    std::sort(both.begin(), both.end());
    model.boundaryConditions.push_back(
        condition(Kind::fixed, "plane1", first, {false, true, false}));
    BoundaryCondition oblique = condition(Kind::fixed, "plane2", both, {true, false, false});
    oblique.axes = {{{-root / 2, 0.5, 0}, {0.5, root / 2, 0}, {0, 0, -1}}};
    model.boundaryConditions.push_back(oblique);
    model.initialVelocities.push_back({"", nodesOfPart(model.mesh, "box"), {3e3, 5e3, -2e3}});
    const auto solver = startedSolver(model, true);
    solver->advance(2e-5, 100000);
    const NodeValues on = solver->nodes().values(edge), mirror = solver->nodes().values(second);
    double along = 0;
    for (std::size_t i = 0; i < on.count; ++i) {
        const Point& start = model.mesh.points[std::size_t(edge[i])];
        EXPECT_NEAR(on.at(0, i)[0], start[0], 1e-14);
        EXPECT_NEAR(on.at(0, i)[1], start[1], 1e-14);
        along = std::max(along, std::abs(on.at(0, i)[2] - start[2]));
    }
    EXPECT_GT(along, 1e-3);
    for (std::size_t i = 0; i < mirror.count; ++i)
        EXPECT_NEAR(mirror.at(0, i)[1], root * mirror.at(0, i)[0], 1e-13);
    // What only holds does no work.
    EXPECT_LT(std::abs(solver->ledger().nodalWorks().drives),
              1e-12 * solver->ledger().energies().kinetic);
}

TEST(LocalAxes, ARotationCarriesPointsRoundTheirAxis)
{
    Model model =
        boxModel({2, 2, 2}, {2, 2, 2}, aluminium(PartKind::elastic, HourglassForm::physical));
    BoundaryCondition turn =
        condition(Kind::rotation, "turn", nodesOfPart(model.mesh, "box"), {true, true, true});
    const double third = 1 / std::sqrt(3.0);
    turn.line = {Point{1, -2, 0.5}, Point{third, third, third}};
    turn.angle = 720;
    turn.amplitude = {Amplitude::Kind::table, {{0, 0}, {2e-4, 1}}};
    model.boundaryConditions.push_back(turn);
    const auto solver = startedSolver(model);
    for (const double time : {3.1e-5, 1.7e-4, 2e-4}) {
        solver->advance(time, 1000000);
        const double angle = 4 * pi * time / 2e-4, c = std::cos(angle), s = std::sin(angle);
        const NodeValues values = solver->nodes().values({});
        for (std::size_t i = 0; i < values.count; ++i) {
            Point r = model.mesh.points[i], side{}, out{};
            for (std::size_t k = 0; k < 3; ++k) r[k] -= turn.line[0][k];
            const double axial = third * (r[0] + r[1] + r[2]);
            for (std::size_t k = 0; k < 3; ++k) side[k] = third * (r[(k + 2) % 3] - r[(k + 1) % 3]);
            for (std::size_t k = 0; k < 3; ++k)
                out[k] = turn.line[0][k] + c * r[k] + s * side[k] + (1 - c) * axial * third;
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(values.at(0, i)[k], out[k], 3e-13);
        }
        EXPECT_LT(largestStress(*solver), 1e-6); // E = 70000
    }
}

} // namespace
} // namespace fpm::test
