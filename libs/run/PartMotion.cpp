#include "run/PartMotion.h"

#include "mesh/Vector.h"

#include <algorithm>

namespace fpm {

namespace {

using namespace vector;

PartMotionValues bodyValues(Solver& solver, std::size_t number)
{
    const RigidBody& body = solver.bodies().setUp().bodies[number];
    const BodyMotionValues motion = solver.bodies().motion(number);
    return {sum(Point{body.start.x, body.start.y, body.start.z}, motion.displacement),
            scaled(motion.velocity, body.mass), motion.momentum, motion.kinetic};
}

} // namespace

PartMotion::PartMotion(const Solver& solver, const Mesh& mesh, Index part)
{
    const auto body = std::ranges::find(solver.bodies().setUp().part, part);
    body_ = std::size_t(body - solver.bodies().setUp().part.begin());
    rigid_ = body != solver.bodies().setUp().part.end();
    if (rigid_) return;
    const MeshPart& run = mesh.parts[std::size_t(part)];
    std::vector<double> mass(mesh.points.size(), 0.0);
    for (Index element = run.firstElement; element < run.firstElement + run.elementCount; ++element)
        for (const Index node : mesh.hexahedra[std::size_t(element)])
            mass[std::size_t(node)] += solver.elements().setUp().massOf(element) / 8;
    for (std::size_t node = 0; node < mass.size(); ++node)
        if (mass[node] > 0) {
            nodes_.push_back(Index(node));
            mass_.push_back(mass[node]);
        }
}

PartMotionValues PartMotion::of(Solver& solver) const
{
    if (rigid_) return bodyValues(solver, body_);
    const NodeValues values = solver.nodes().values(nodes_);
    double total = 0;
    PartMotionValues out;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Point v = values.at(1, i);
        total += mass_[i];
        out.centre = sum(out.centre, scaled(values.at(0, i), mass_[i]));
        out.momentum = sum(out.momentum, scaled(v, mass_[i]));
        out.kinetic += 0.5 * mass_[i] * dot(v, v);
    }
    out.centre = scaled(out.centre, 1 / total);
    const Point mean = scaled(out.momentum, 1 / total);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        out.angularMomentum =
            sum(out.angularMomentum, scaled(cross(difference(values.at(0, i), out.centre),
                                                  difference(values.at(1, i), mean)),
                                            mass_[i]));
    return out;
}

} // namespace fpm
