#include "stability/SceneTools.h"

#include "mesh/Patches.h"

#include <cmath>

namespace fpm {

Part aluminiumPart(const std::string& name, double poissonsRatio)
{
    Part part;
    part.name = name;
    part.density = 2.7e-9;
    part.youngsModulus = 70000;
    part.poissonsRatio = poissonsRatio;
    part.hourglass = HourglassForm::stiffness;
    return part;
}

std::vector<ElementSide> facing(const Mesh& mesh, const std::string& part, Point direction)
{
    std::vector<ElementSide> chosen;
    for (const ElementSide& side : skin(mesh, mesh.findPart(part))) {
        const Point n = normal(mesh, side);
        if (n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2] > 0.7)
            chosen.push_back(side);
    }
    return chosen;
}

std::vector<Index> nodesWhere(const Mesh& mesh, const std::function<bool(Point)>& here)
{
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (here(mesh.points[i])) nodes.push_back(Index(i));
    return nodes;
}

std::vector<Index> nodesOfPart(const Mesh& mesh, const std::string& name)
{
    return nodesOfPart(mesh, mesh.findPart(name));
}

ContactPair& addContact(Model& model,
                        const std::string& name,
                        const std::vector<ElementSide>& contactor,
                        const std::vector<ElementSide>& target)
{
    ContactPair pair;
    pair.name = name;
    pair.contactorNodes = nodesOf(model.mesh, contactor);
    pair.targetSides = target;
    pair.initialOverlap = InitialOverlap::report; // scenes begin pressed together
    model.mesh.contact.push_back({name, pair.contactorNodes, contactor, target});
    model.contactPairs.push_back(pair);
    return model.contactPairs.back();
}

BoundaryCondition condition(BoundaryCondition::Kind kind,
                            const std::string& name,
                            const std::vector<Index>& nodes,
                            std::array<bool, 3> components,
                            Point value,
                            const Amplitude& amplitude)
{
    BoundaryCondition made;
    made.kind = kind;
    made.name = name;
    made.nodes = nodes;
    made.constrains = components;
    made.value = value;
    made.amplitude = amplitude;
    return made;
}

void holdFixed(Model& model, const std::vector<Index>& nodes)
{
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::fixed, "fixed", nodes, {true, true, true}));
}

void throwPart(Model& model, const std::string& part, Point velocity)
{
    InitialVelocity initial;
    initial.name = "throw";
    initial.nodes = nodesOfPart(model.mesh, part);
    initial.velocity = velocity;
    model.initialVelocities.push_back(initial);
}

void finishScene(Model& model, Index patch)
{
    renumber(model.mesh, patch);
    model.control.backend = "serial";
    model.control.endTime = 1;
}

std::unique_ptr<Solver> startedSolver(const Model& model, bool audit)
{
    std::unique_ptr<Solver> solver = makeSolver(model, audit);
    solver->start();
    return solver;
}

std::vector<Point> halfStepVelocities(Solver& solver)
{
    const NodeValues values = solver.nodes().values({});
    const double half = 0.5 * solver.clock().step;
    std::vector<Point> out(values.count);
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point v = values.at(1, i), a = values.at(2, i);
        for (std::size_t c = 0; c < 3; ++c) out[i][c] = v[c] - half * a[c];
    }
    return out;
}

Point momentum(Solver& solver, const std::vector<Index>& list)
{
    const std::vector<Point> v = halfStepVelocities(solver);
    const std::vector<double>& mass = solver.nodes().setUp().mass;
    Point sum{0, 0, 0};
    const auto add = [&](std::size_t i) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += mass[i] * v[i][c];
    };
    if (list.empty())
        for (std::size_t i = 0; i < v.size(); ++i) add(i);
    for (const Index node : list) add(std::size_t(node));
    return sum;
}

Point angularMomentum(Solver& solver)
{
    const std::vector<Point> v = halfStepVelocities(solver);
    const NodeValues values = solver.nodes().values({});
    Point sum{0, 0, 0};
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Point x = values.at(0, i);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
            sum[c] += solver.nodes().setUp().mass[i] * (x[a] * v[i][b] - x[b] * v[i][a]);
        }
    }
    return sum;
}

double lengthOf(const Point& p)
{
    return std::hypot(p[0], p[1], p[2]);
}

} // namespace fpm
