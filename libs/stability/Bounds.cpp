#include "stability/Bounds.h"

#include "mesh/Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

/// Velocities v^(3/2) of all nodes after two small steps from velocities `start`.
std::vector<Point> respond(Model model, const std::vector<Point>& start)
{
    model.initialVelocities.clear();
    for (Index node = 0; node < Index(start.size()); ++node) {
        InitialVelocity initial;
        initial.nodes = {node};
        initial.velocity = start[std::size_t(node)];
        model.initialVelocities.push_back(initial);
    }
    const auto solver = makeSolver(model);
    solver->start();
    solver->advance(model.control.endTime, 2);
    const NodeValues values = solver->nodes().values({});
    const double half = 0.5 * solver->clock().step;
    std::vector<Point> out(values.count);
    for (std::size_t i = 0; i < values.count; ++i) {
        const Point v = values.at(1, i), a = values.at(2, i);
        for (std::size_t c = 0; c < 3; ++c) out[i][c] = v[c] - half * a[c];
    }
    return out;
}

/// Width of a face in contact; of an element's where there is none.
double faceWidth(const Mesh& mesh)
{
    if (!mesh.contact.empty() && !mesh.contact.front().contactorSides.empty())
        return std::sqrt(area(mesh, mesh.contact.front().contactorSides.front()));
    return std::sqrt(area(mesh, ElementSide{0, 0}));
}

/// Moves the contactors of a pair into its target, where that has one normal direction.
void press(Model& model, const ContactPair& pair, double depth)
{
    Point mean{0, 0, 0};
    for (const ElementSide& side : pair.targetSides) {
        const Point n = normal(model.mesh, side);
        for (std::size_t c = 0; c < 3; ++c) mean[c] += n[c] / double(pair.targetSides.size());
    }
    if (pair.surface >= 0) {
        RigidSurface& surface = model.rigidSurfaces[std::size_t(pair.surface)];
        if (surface.kind != RigidSurface::Kind::plane) return;
        for (std::size_t c = 0; c < 3; ++c) surface.point[c] += depth * surface.axis[c];
    } else if (std::hypot(mean[0], mean[1], mean[2]) > 0.9)
        for (const Index node : pair.contactorNodes)
            for (std::size_t c = 0; c < 3; ++c)
                model.mesh.points[std::size_t(node)][c] -= depth * mean[c];
}

/// Pressed together, without friction, viscosity and damping: what has a symmetric stiffness.
Model pressed(const Model& given, double depth, double step)
{
    Model model = given;
    for (ContactPair& pair : model.contactPairs) {
        press(model, pair, depth);
        pair.friction = pair.normalDamping = 0;
        pair.initialOverlap = InitialOverlap::report;
    }
    for (Part& part : model.parts) part.linearBulkViscosity = part.quadraticBulkViscosity = 0;
    for (RigidSurface& surface : model.rigidSurfaces) surface.motion = RigidSurface::Motion::none;
    model.control.massDamping = 0;
    model.control.fixedTimeStep = step;
    model.control.beyondBound = true;
    model.control.searchInterval = 0;
    model.control.endTime = 1e6 * step;
    return model;
}

} // namespace

StepClock firstStep(const Model& model)
{
    const auto solver = makeSolver(model);
    solver->start();
    solver->advance(model.control.endTime, 1);
    return solver->clock();
}

Bounds boundsOf(const Model& given)
{
    Model model = given;
    model.control.fixedTimeStep = 0;
    model.control.beyondBound = false;
    const StepClock clock = firstStep(model);
    Bounds out;
    out.elementStep = clock.elementStep;
    out.withContact = clock.stableStep / clock.elementStep;
    if (clock.contactFrequency > 0)
        out.quality = Control{}.contactStepLimit / (clock.contactFrequency * clock.elementStep);
    return out;
}

double largestFrequency(const Model& given, double elementStep)
{
    const double depth = 1e-5 * faceWidth(given.mesh);
    const Model model = pressed(given, depth, 0.05 * elementStep);
    const std::size_t count = model.mesh.points.size();
    const double step = model.control.fixedTimeStep;
    const std::vector<Point> rest = respond(model, std::vector<Point>(count, Point{0, 0, 0}));

    std::vector<Point> mode(count);
    for (std::size_t i = 0; i < count; ++i) // no symmetry that a mode could hide behind
        for (std::size_t c = 0; c < 3; ++c) mode[i][c] = std::sin(double(7 * i + 3 * c + 1));
    // Displacements stay far below the depth of the contact.
    const double size = 1e-3 * depth / step;
    double square = 0;
    for (int iteration = 0; iteration < 60; ++iteration) {
        double most = 0;
        for (const Point& v : mode)
            for (const double c : v) most = std::max(most, std::abs(c));
        if (!(most > 0)) return 0;
        for (Point& v : mode)
            for (double& c : v) c *= size / most;
        const std::vector<Point> moved = respond(model, mode);
        double product = 0, norm = 0;
        std::vector<Point> next(count, Point{0, 0, 0});
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                if (moved[i][c] == rest[i][c]) continue; // held or driven
                next[i][c] = (mode[i][c] - (moved[i][c] - rest[i][c])) / (step * step);
                product += mode[i][c] * next[i][c];
                norm += mode[i][c] * mode[i][c];
            }
        square = product / norm;
        mode = next;
    }
    return std::sqrt(std::max(0.0, square));
}

} // namespace fpm
