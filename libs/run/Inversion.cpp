#include "run/Inversion.h"

#include "base/Format.h"
#include "mesh/Vector.h"
#include "solver/elements/ElementStep.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fpm {

namespace {

constexpr int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                              {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
/// Edges shorter or longer than this by comparison with the start are large deformation.
constexpr double shortEdge = 0.5, longEdge = 2;

/// The element whose edges have changed the most among those without volume, where it lies and how.
struct Crushed {
    Index element = -1;
    std::size_t count = 0;
    double shortest = 1, longest = 1; ///< edge, over its length at the start
    Point place{};
};

std::array<Point, 8> cornersNow(const NodeValues& nodes, const Hexahedron& element)
{
    std::array<Point, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = nodes.at(0, std::size_t(element[i]));
    return corners;
}

double edgeLength(const std::array<Point, 8>& x, const int (&edge)[2])
{
    return vector::length(vector::difference(x[std::size_t(edge[1])], x[std::size_t(edge[0])]));
}

Crushed crushedOf(Solver& solver, const Model& model)
{
    const NodeValues nodes = solver.nodes().values({});
    const std::vector<bool> deleted = solver.elements().values().deleted;
    Crushed found;
    double most = -1;
    for (Index e = 0; e < Index(model.mesh.hexahedra.size()); ++e) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(e))];
        if (isRigid(part.kind) || deleted[std::size_t(e)]) continue;
        const auto now = cornersNow(nodes, model.mesh.hexahedra[std::size_t(e)]);
        if (stableStep(part, now, solver.elements().setUp().massOf(e)) > 0) continue;
        ++found.count;
        const auto before = cornersOf(model.mesh, e);
        double shortest = 1e300, longest = 0;
        for (const auto& edge : edges) {
            const double ratio = edgeLength(now, edge) / edgeLength(before, edge);
            if (!std::isfinite(ratio)) return {e, 1, 1, ratio, {}};
            shortest = std::min(shortest, ratio);
            longest = std::max(longest, ratio);
        }
        const double change = std::max(longest, 1 / std::max(shortest, 1e-300));
        if (change <= most) continue;
        most = change;
        Point sum{0, 0, 0};
        for (const Point& corner : now) sum = vector::sum(sum, corner);
        found = {e, found.count, shortest, longest, vector::scaled(sum, 0.125)};
    }
    return found;
}

std::string adviceFor(const Part& part, const Crushed& crushed)
{
    if (crushed.shortest > shortEdge && crushed.longest < longEdge)
        return "its edges have kept their lengths: try a smaller timeStep.safety, or a smaller "
               "normalScale of the pair that presses on it";
    std::string advice =
        "the deformation is too large for this mesh and material, which a smaller step does not "
        "change: ";
    if (part.erosion.inverted)
        return advice
               + "use coarser or pre-shaped elements there, or a material that stiffens at large "
                 "strain";
    advice += part.hexahedron == HexahedronForm::selective
                  ? "let part " + part.name
                        + " have hexahedron reduced and erosion { inverted yes; }, which deletes "
                          "such elements; "
                  : "let part " + part.name
                        + " have erosion { inverted yes; }, which deletes such elements; ";
    return advice
           + "or use coarser or pre-shaped elements there, or a material that stiffens at large "
             "strain";
}

} // namespace

Inversion inversionOf(Solver& solver, const Model& model)
{
    const Crushed crushed = crushedOf(solver, model);
    if (crushed.element < 0 || !std::isfinite(crushed.longest))
        return {"velocities, places or forces are no numbers any more", noNumberAdvice};
    const Part& part = model.parts[std::size_t(model.mesh.partOf(crushed.element))];
    const Point& at = crushed.place;
    return {format("element {} of part {}{} no positive volume any more: at ({} {} {}), its edges "
                   "are {} to {} times as long as at the start",
                   crushed.element, part.name,
                   crushed.count > 1 ? format(" and {} others have", crushed.count - 1) : " has",
                   toText(at[0], 4), toText(at[1], 4), toText(at[2], 4),
                   toText(crushed.shortest, 2), toText(crushed.longest, 2)),
            adviceFor(part, crushed)};
}

} // namespace fpm
