#include "solver/contact/Penalties.h"

#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "solver/contact/MirrorPlanes.h"
#include "solver/elements/ElementStep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace fpm {

namespace {

/// K A^2 / V of the element behind a side: the penalty of Hallquist et al. 1985. 0: rigid.
double penalty(const Model& model, const ElementSide& side)
{
    const Part& part = model.parts[std::size_t(model.mesh.partOf(side.element))];
    if (isRigid(part.kind)) return 0;
    const double bulk = part.youngsModulus / (3 * (1 - 2 * part.poissonsRatio));
    const double a = area(model.mesh, side);
    return bulk * a * a / volume(model.mesh, side.element);
}

/// Masses of nodes with their images in planes of symmetry: what a whole model has.
struct WholeMasses {
    const SolverSetUp& data;
    std::vector<MirrorPlane> planes;

    /// 0: nothing can move the node.
    double operator()(Index node) const
    {
        if (data.nodes.fixed[std::size_t(node)] & imposedNode) return 0;
        double mass = data.nodes.mass[std::size_t(node)];
        for (const MirrorPlane& plane : planes)
            if (plane.holds[std::size_t(node)]) mass *= 2;
        return mass;
    }
};

int planesOf(const std::vector<MirrorPlane>& planes, Index node)
{
    return int(std::count_if(planes.begin(), planes.end(), [=](const MirrorPlane& plane) {
        return plane.holds[std::size_t(node)];
    }));
}

/// Mass of the lightest of some nodes that can be moved; 0: none can.
double leastMass(const WholeMasses& massOf, std::span<const Index> nodes)
{
    double least = 0;
    for (const Index node : nodes) {
        const double mass = massOf(node);
        if (mass > 0 && (least == 0 || mass < least)) least = mass;
    }
    return least;
}

/// Mean K A^2 / V of the contactor's own sides around each of its nodes.
std::vector<double> ownStiffness(const Model& model,
                                 const std::vector<Index>& nodes,
                                 const std::vector<ElementSide>& own)
{
    std::map<Index, std::pair<double, int>> around;
    for (const ElementSide& side : own)
        for (const Index node : model.mesh.sideNodes(side)) {
            around[node].first += penalty(model, side);
            ++around[node].second;
        }
    std::vector<double> out;
    for (const Index node : nodes) {
        const auto& [sum, count] = around[node];
        out.push_back(count > 0 ? sum / count : 0);
    }
    return out;
}

/// The planes a contactor lies on, a bit each. On one it is half a node, on two a quarter: it gets
/// as much of the stiffness and has no friction across, so that half a model meets as the whole one
/// does.
std::vector<std::uint8_t> mirrorsOf(const Model& model, const std::vector<Index>& contactors)
{
    const std::vector<MirrorPlane> planes = mirrorPlanes(model);
    std::vector<std::uint8_t> out;
    bool any = false;
    for (const Index node : contactors) {
        unsigned on = 0;
        for (std::size_t plane = 0; plane < planes.size(); ++plane)
            on |= unsigned(planes[plane].holds[std::size_t(node)]) << plane;
        out.push_back(std::uint8_t(on));
        any |= on > 0;
    }
    return any ? out : std::vector<std::uint8_t>{};
}

/// Half of it where both sides have contactors: in two passes, in self- and in general contact.
double scaleOf(const ContactPair& pair)
{
    const bool bothSides = pair.passes == 2 || pair.kind != ContactKind::pair;
    return (bothSides ? 0.5 : 1.0) * pair.normalScale;
}

} // namespace

void addPenalty(ContactPassSetup& out,
                const SolverSetUp& data,
                const Model& model,
                const ContactPair& pair,
                const std::vector<ElementSide>& own,
                const std::vector<ElementSide>& target)
{
    const double scale = scaleOf(pair);
    out.mirrors = mirrorsOf(model, out.contactor);
    const WholeMasses massOf{data, mirrorPlanes(model)};
    // Of a contactor the mass of the model, as of its stiffness; of faces that of the whole model,
    // since contactors beside a plane meet them whole.
    for (const Index node : out.contactor)
        out.contactorMass.push_back(massOf(node) / double(1 << planesOf(massOf.planes, node)));
    for (std::size_t face = 0; face < out.faceNode.size() / 4; ++face)
        out.faceMass.push_back(leastMass(massOf, std::span(out.faceNode).subspan(4 * face, 4)));
    if (entryOf(pair.penalty).byMass) {
        const double step = firstElementStep(data.elements, model), perMass = scale / (step * step);
        for (const double mass : out.contactorMass)
            out.contactorStiffness.push_back(perMass * mass);
        for (const double mass : out.faceMass) out.faceStiffness.push_back(perMass * mass);
        return;
    }
    for (const ElementSide& side : target)
        out.faceStiffness.push_back(scale * penalty(model, side));
    const bool rigidFaces =
        out.faceStiffness.empty()
        || *std::min_element(out.faceStiffness.begin(), out.faceStiffness.end()) <= 0;
    if (!entryOf(pair.penalty).bothSides && !rigidFaces) return;
    for (const double stiffness : ownStiffness(model, out.contactor, own))
        out.contactorStiffness.push_back(scale * stiffness);
}

void addEdgePenalty(ContactPassSetup& out,
                    const SolverSetUp& data,
                    const Model& model,
                    const ContactPair& pair,
                    const std::vector<SharpEdge>& edges)
{
    const bool byMass = entryOf(pair.penalty).byMass;
    const WholeMasses massOf{data, mirrorPlanes(model)};
    if (!entryOf(pair.penalty).bothSides) out.law.penalty = PenaltyRule::lesser;
    const double step = byMass ? firstElementStep(data.elements, model) : 1;
    for (const SharpEdge& edge : edges) {
        out.faceMass.push_back(leastMass(massOf, std::span(edge.nodes).first(2)));
        double sum = 0;
        for (const ElementSide& side : edge.sides) sum += penalty(model, side);
        out.faceStiffness.push_back(
            pair.normalScale
            * (byMass ? out.faceMass.back() / (step * step) : sum / double(edge.sides.size())));
    }
    const std::size_t own = std::size_t(out.nodeCount);
    for (std::size_t i = 0; i < out.contactor.size(); ++i) {
        out.contactorMass.push_back(out.faceMass[i % own]);
        out.contactorStiffness.push_back(out.faceStiffness[i % own]);
    }
    const auto [least, most] = std::ranges::minmax(out.faceStiffness);
    out.unequalFaces = most > (1 + 1e-9) * least;
}

double largestStiffness(const ContactPassSetup& pass)
{
    double most = 0;
    for (const double k : pass.faceStiffness) most = std::max(most, k);
    for (const double k : pass.contactorStiffness) most = std::max(most, k);
    return most;
}

double dampingLimit(const ContactLaw& law)
{
    const double z = law.normalDamping, root = std::sqrt(1 + z * z) + z;
    return root * root;
}

Condition surfaceMotion(const RigidSurface& surface, std::vector<double>& amplitudeRows)
{
    const bool byVelocity = surface.motion == RigidSurface::Motion::velocity;
    return makeCondition(byVelocity ? ConditionKind::velocity : ConditionKind::displacement,
                         surface.value, surface.amplitude, amplitudeRows);
}

SurfaceShape surfaceShape(const RigidSurface& surface, std::vector<double>& amplitudeRows)
{
    using Kind = RigidSurface::Kind;
    using Motion = RigidSurface::Motion;
    SurfaceShape out{};
    out.kind = surface.kind == Kind::plane      ? SurfaceShape::plane
               : surface.kind == Kind::cylinder ? SurfaceShape::cylinder
                                                : SurfaceShape::sphere;
    out.inside = surface.inside;
    out.bounded = surface.kind == Kind::cylinder && !surface.infinite;
    out.moves = surface.motion != Motion::none;
    out.point = {surface.point[0], surface.point[1], surface.point[2]};
    out.axis = {surface.axis[0], surface.axis[1], surface.axis[2]};
    out.length = surface.length;
    out.radius = surface.radius;
    out.motion = surfaceMotion(surface, amplitudeRows);
    return out;
}

ContactPassSetup makeSurfacePair(const SolverSetUp& data,
                                 const Model& model,
                                 const ContactPair& pair,
                                 const std::vector<ElementSide>& own)
{
    ContactPassSetup out;
    out.law = pair;
    out.surface = pair.surface;
    out.kinematic = !pair.hasSprings();
    out.contactor = pair.contactorNodes;
    out.nodeCount = Index(out.contactor.size());
    if (out.kinematic)
        out.mirrors = mirrorsOf(model, out.contactor);
    else
        addPenalty(out, data, model, pair, own, {});
    double areas = 0;
    for (const ElementSide& side : own) areas += area(model.mesh, side);
    if (!own.empty()) out.meanFaceSize = std::sqrt(areas / double(own.size()));
    out.reach = 0.25 * out.meanFaceSize;
    // A half space has no thickness: no deeper than the whole mesh is large.
    Point low = model.mesh.points.front(), high = low;
    for (const Point& p : model.mesh.points)
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    out.deepest = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    return out;
}

} // namespace fpm
