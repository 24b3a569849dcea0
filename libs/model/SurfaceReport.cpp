#include "model/SurfaceReport.h"

#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fpm {

namespace {

const char* kindName(RigidSurface::Kind kind)
{
    return kind == RigidSurface::Kind::plane      ? "plane"
           : kind == RigidSurface::Kind::cylinder ? "cylinder"
                                                  : "sphere";
}

double contactorArea(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    double sum = 0;
    for (const ElementSide& side : surfaces.contactorSides) sum += area(mesh, side);
    return sum;
}

double meanWidth(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    return std::sqrt(contactorArea(mesh, surfaces) / double(surfaces.contactorSides.size()));
}

} // namespace

SurfaceFit measureSurfaceContact(const Mesh& mesh,
                                 const ContactSurfaces& surfaces,
                                 const RigidSurface& surface)
{
    SurfaceFit fit;
    fit.smallestGap = std::numeric_limits<double>::infinity();
    const double touching = 1e-6 * meanWidth(mesh, surfaces);
    std::set<Index> facing, inside;
    double sum = 0;
    for (const ElementSide& side : surfaces.contactorSides)
        for (const Index node : mesh.sideNodes(side)) {
            Point outward{};
            const double gap = surface.gap(mesh.points[std::size_t(node)], outward);
            if (gap < -touching && inside.insert(node).second && -gap > fit.deepest) {
                fit.deepest = -gap;
                fit.deepestNode = node;
            }
            if (gap < -touching || !std::isfinite(gap) || dot(normal(mesh, side), outward) >= 0
                || !facing.insert(node).second)
                continue;
            fit.smallestGap = std::min(fit.smallestGap, std::max(gap, 0.0));
            sum += std::max(gap, 0.0);
        }
    fit.facingNodes = facing.size();
    fit.overlaps = inside.size();
    if (fit.facingNodes > 0)
        fit.meanGap = sum / double(fit.facingNodes);
    else
        fit.smallestGap = 0;
    return fit;
}

void reportSurfaceContact(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const RigidSurface& surface,
                          Log& log)
{
    const SurfaceFit fit = measureSurfaceContact(mesh, surfaces, surface);
    log.line(format("pair {}: {} contactor nodes (area {}), target: analytic {} {}", surfaces.pair,
                    surfaces.contactorNodes.size(), contactorArea(mesh, surfaces),
                    kindName(surface.kind), surface.name));
    if (fit.facingNodes > 0)
        log.line(format("    initial gap: smallest {}, mean {} over {} nodes that face the target",
                        fit.smallestGap, fit.meanGap, fit.facingNodes));
    else if (fit.overlaps == 0)
        log.warning(
            format("pair {}: no contactor node faces the surface {}", surfaces.pair, surface.name));
    if (fit.overlaps > 0)
        log.warning(format("pair {}: {} contactor nodes lie inside the surface {}, deepest {} at "
                           "node {} {}; they are pushed out at the first step",
                           surfaces.pair, fit.overlaps, surface.name, fit.deepest, fit.deepestNode,
                           pointText(mesh.points[std::size_t(fit.deepestNode)])));
}

void refuseSurfaceOverlap(const Mesh& mesh,
                          const ContactSurfaces& surfaces,
                          const RigidSurface& surface,
                          const Dictionary& place)
{
    if (place.has("initialOverlap") || surfaces.contactorSides.empty()) return;
    const SurfaceFit fit = measureSurfaceContact(mesh, surfaces, surface);
    const double most = 0.01 * meanWidth(mesh, surfaces);
    if (fit.deepest <= most) return;
    place.fail("target",
               format("pair {}: {} contactor nodes begin inside the surface {}, deepest {} at node "
                      "{} {}: the springs would throw the body out",
                      surfaces.pair, fit.overlaps, surface.name, fit.deepest, fit.deepestNode,
                      pointText(mesh.points[std::size_t(fit.deepestNode)])),
               "move the body or the surface apart; or write 'initialOverlap report;' in the pair "
               "if the first step should push them out");
}

} // namespace fpm
