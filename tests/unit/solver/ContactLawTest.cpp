#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

constexpr double turn = 2 * M_PI;

/// Two bricks pressed together, the upper one sheared by `slip` and then both turned about `axis`
/// once round: every node is moved as prescribed, so that what contact does is geometry alone.
Model turningPair(char axis, const char* form)
{
    Model model;
    addBox(model.mesh, "lower", {2, 2, 1}, {-2, -2, -1}, {4, 4, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {-0.7, -0.9, -0.01}, {1, 1, 1});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "lower"),
                   aluminium(PartKind::elastic, HourglassForm::stiffness, "upper")};
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = 0.9;
    pair.paperFriction = std::string(form) == "paper";
    pair.tangentialScale = 0.1; // friction bears what the shear asks for
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    const int rows = 400;
    const double shearTime = 1e-5, time = 4e-4;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const Point p = model.mesh.points[i];
        const bool above = std::binary_search(upper.begin(), upper.end(), Index(i));
        const Point sheared{p[0] + (above ? 0.02 : 0), p[1] - (above ? 0.01 : 0), p[2]};
        for (std::size_t c = 0; c < 3; ++c) {
            Amplitude amplitude{Amplitude::Kind::table, {{0, 0}, {shearTime, sheared[c] - p[c]}}};
            for (int n = 1; n <= rows; ++n) {
                const double angle = turn * n / rows, s = std::sin(angle), k = std::cos(angle);
                const auto& [x, y, z] = sheared;
                const Point turned = axis == 'x'   ? Point{x, k * y - s * z, s * y + k * z}
                                     : axis == 'y' ? Point{k * x + s * z, y, k * z - s * x}
                                                   : Point{k * x - s * y, s * x + k * y, z};
                amplitude.rows.push_back({shearTime + time * n / rows, turned[c] - p[c]});
            }
            std::array<bool, 3> components{false, false, false};
            components[c] = true;
            Point value{0, 0, 0};
            value[c] = 1;
            model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::displacement,
                                                         "turn", {Index(i)}, components, value,
                                                         amplitude));
        }
    }
    model.control.backend = "serial";
    model.control.fixedTimeStep = 5e-8;
    model.control.endTime = 1;
    return model;
}

/// The contact force, turned back by `angle`.
Point turnedBack(const Point& f, char axis, double angle)
{
    const double s = std::sin(angle), k = std::cos(angle);
    const auto& [x, y, z] = f;
    return axis == 'x'   ? Point{x, k * y + s * z, k * z - s * y}
           : axis == 'y' ? Point{k * x - s * z, y, s * x + k * z}
                         : Point{k * x + s * y, k * y - s * x, z};
}

TEST(ContactLaw, StuckPairKeepsItsTractionThroughAFullTurn)
{
    for (const char axis : {'x', 'y', 'z'}) {
        const auto solver = startedSolver(turningPair(axis, "objective"));
        solver->advance(1e-5, 100000);
        const Point start = solver->contact().force(0).force;
        const double tangential = std::hypot(start[0], start[1]);
        EXPECT_GT(tangential, 0.1 * start[2]);
        EXPECT_NEAR(start[0] / start[1], -2, 1e-6); // against the shear
        const double lost = solver->ledger().energies().friction;
        for (int part = 1; part <= 8; ++part) {
            solver->advance(1e-5 + 4e-4 * part / 8, 1000000);
            const Point now = turnedBack(solver->contact().force(0).force, axis, turn * part / 8);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(now[c], start[c], 0.01 * tangential)
                    << axis << " after " << part << " eighths, component " << c;
        }
        EXPECT_NEAR(solver->ledger().energies().friction, lost, 1e-12);
    }
}

TEST(ContactLaw, StuckPairKeepsItsTractionInEveryPrecision)
{
    for (const Precision precision : {Precision::mixed, Precision::single}) {
        Model model = turningPair('z', "objective");
        model.control.precision = precision;
        const auto solver = startedSolver(model);
        solver->advance(1e-5, 100000);
        const Point start = solver->contact().force(0).force;
        solver->advance(1e-5 + 4e-4, 1000000);
        const Point now = solver->contact().force(0).force;
        const double tangential = std::hypot(start[0], start[1]);
        for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(now[c], start[c], 0.01 * tangential);
    }
}

TEST(ContactLaw, FrictionAsPrintedDoesNotTurnWithTheBodies)
{
    const auto solver = startedSolver(turningPair('z', "paper"));
    solver->advance(1e-5, 100000);
    const Point start = solver->contact().force(0).force;
    solver->advance(1e-5 + 4e-4 / 4, 1000000);
    const Point now = solver->contact().force(0).force;
    EXPECT_NEAR(now[0], start[0], 0.05 * std::hypot(start[0], start[1])); // still along x, y
    EXPECT_NEAR(now[1], start[1], 0.05 * std::hypot(start[0], start[1]));
}

/// Two columns of different stuff, pressed; penetration = force / stiffness.
double measuredStiffness(PenaltyRule rule, bool rigidTarget = false)
{
    Model model;
    addBox(model.mesh, "lower", {1, 1, 1}, {0, 0, -1}, {1, 1, 1});
    addBox(model.mesh, "upper", {1, 1, 1}, {0, 0, 0}, {1, 1, 0.5});
    renumber(model.mesh);
    for (const char* name : {"lower", "upper"}) {
        Part part = aluminium(PartKind::elastic, HourglassForm::stiffness, name);
        part.poissonsRatio = 0;
        model.parts.push_back(part);
    }
    model.parts[0].youngsModulus = 30000;
    if (rigidTarget) {
        model.parts[0].kind = PartKind::rigidPrescribed;
        holdFixed(model, nodesOfPart(model.mesh, "lower"));
    } else
        holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -0.99; }));
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::force, "load",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 0.49; }), {false, false, true},
                  {0, 0, -100}, {Amplitude::Kind::smooth, {{0, 0}, {1e-5, 1}}}));
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.penalty = rule;
    if (rule == PenaltyRule::mass) pair.normalScale = 0.1;
    model.control.backend = "serial";
    model.control.massDamping = 2e6;
    const auto solver = startedSolver(model);
    solver->advance(1e-4, 1000000);
    const NodeValues values = solver->nodes().values({});
    double gap = 0;
    for (const Index i : model.contactPairs[0].contactorNodes)
        gap += values.at(0, std::size_t(i))[2] / 4;
    for (const Index i : nodesOf(model.mesh, model.contactPairs[0].targetSides))
        gap -= values.at(0, std::size_t(i))[2] / 4;
    return -solver->contact().force(0).force[2] / (4 * gap);
}

TEST(ContactLaw, PenaltyTakesTheStiffnessAskedFor)
{
    // K A^2 / V, K = E / 3: 10000 below, 2 * 70000 / 3 above (half as thick).
    const double below = 1e4, above = 2 * 7e4 / 3;
    EXPECT_NEAR(measuredStiffness(PenaltyRule::target), below, 1e-3 * below);
    EXPECT_NEAR(measuredStiffness(PenaltyRule::lesser), below, 1e-3 * below);
    EXPECT_NEAR(measuredStiffness(PenaltyRule::series), below * above / (below + above),
                1e-3 * below);
    for (const PenaltyRule rule : {PenaltyRule::target, PenaltyRule::lesser, PenaltyRule::series})
        EXPECT_NEAR(measuredStiffness(rule, true), above, 1e-3 * above);
    // 0.1 m / dt^2 of the lighter side, one eighth of half a cubic mm; dt of the thinner brick with
    // z = 0.06 and c^2 = E / rho: dt^2 = (sqrt(1 + z^2) - z)^2 / (1 + 1 + 4) / c^2.
    const double z = 0.06, root = std::sqrt(1 + z * z) - z;
    const double step2 = root * root / 6 * 2.7e-9 / 7e4, mass = 2.7e-9 * 0.5 / 8;
    EXPECT_NEAR(measuredStiffness(PenaltyRule::mass), 0.1 * mass / step2, 2e-3 * mass / step2);
}

TEST(ContactLaw, DampedImpactOfBlocksBooksWhatItTakes)
{
    Model model =
        twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {0, 0, -4e4}, 0.2);
    const auto plain = startedSolver(model);
    model.contactPairs[0].normalDamping = 0.3;
    const auto damped = startedSolver(model);
    plain->advance(1.2e-5, 100000);
    damped->advance(1.2e-5, 100000);
    EXPECT_EQ(plain->ledger().energies().contactDamping, 0);
    EXPECT_GT(damped->ledger().energies().contactDamping, 0);
    EXPECT_LT(std::abs(damped->ledger().energies().balance), 0.005);
    EXPECT_GT(damped->clock().contactFrequency, plain->clock().contactFrequency * 1.2);
}

TEST(ContactLaw, DynamicFrictionSlowsByTheDynamicCoefficient)
{
    Model model =
        twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                  aluminium(PartKind::elastic, HourglassForm::stiffness), {8e4, 0, -1e4}, 0.4);
    model.contactPairs[0].dynamicFriction = 0.2;
    model.contactPairs[0].frictionDecay = 1e-3; // of 80 m/s
    model.contactPairs[0].slipDamping = 0; // the slip slows at once
    const auto solver = startedSolver(model);
    const std::vector<Index> upper = nodesOfPart(model.mesh, "upper");
    const Point before = momentum(*solver, upper);
    solver->advance(4e-6, 100000);
    const Point after = momentum(*solver, upper);
    const double normal = after[2] - before[2];
    EXPECT_NEAR(after[0] - before[0], -0.2 * normal, 0.03 * 0.2 * normal);
}

/// A rigid brick led at a multiple of the wave speed into a fixed block of unit cells, from a
/// height of `start`. True when the contact took hold of it before it was through the first layer.
bool caught(double speed, double start, ContactSearch search = ContactSearch::faces)
{
    Model model;
    addBox(model.mesh, "block", {4, 4, 3}, {-2, -2, -3}, {4, 4, 3});
    addBox(model.mesh, "brick", {1, 1, 1}, {-0.4, -0.3, start}, {1, 1, 1});
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::stiffness, "block"),
                   aluminium(PartKind::rigidPrescribed, HourglassForm::stiffness, "brick")};
    const std::vector<Index> brick = nodesOfPart(model.mesh, "brick");
    const double c = std::sqrt(materialConstants(model.parts[0]).pressureWaveModulus / 2.7e-9);
    const Point velocity{0, 0, -speed * c};
    model.initialVelocities.push_back({"led", brick, velocity});
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::velocity, "led", brick, {true, true, true}, velocity));
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -2.99; }));
    addContact(model, "touch", facing(model.mesh, "brick", {0, 0, -1}),
               facing(model.mesh, "block", {0, 0, 1}))
        .search = search;
    model.control.backend = "serial";
    model.control.endTime = 1;
    const auto solver = startedSolver(model);
    while (solver->clock().time * speed * c < start + 1.5 && !solver->clock().failed) {
        solver->advance(1, 1);
        if (solver->contact().force(0).active == 4) return true;
    }
    return false;
}

TEST(ContactLaw, NoContactorIsLostUpToTheSpeedOfWaves)
{
    // With both searches: the step bounds the displacement. The first loss is at 1.3 times the wave
    // speed: a step is then longer than reach and half a cell together, the depth at which a
    // contactor is still found.
    for (const double speed : {0.01, 0.1, 0.3, 1.0})
        for (double start = 0.3; start < 0.9; start += 0.07)
            for (const ContactSearch search :
                 {ContactSearch::faces, ContactSearch::closestParticle})
                EXPECT_TRUE(caught(speed, start, search)) << speed << " c from " << start;
}

} // namespace
} // namespace fpm::test
