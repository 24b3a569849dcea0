#include "base/Error.h"
#include "base/Format.h"
#include "kernels/contact/ContactPassView.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "solver/contact/EdgeSetUp.h"
#include "solver/contact/MirrorPlanes.h"
#include "solver/contact/Penalties.h"
#include "solver/elements/ModelSizes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fpm {

namespace {

/// Sides of the contactor's surface, from the mesh; the contactor's nodes lie on them.
const std::vector<ElementSide>& ownSides(const Model& model, const ContactPair& pair)
{
    for (const ContactSurfaces& surfaces : model.mesh.contact)
        if (surfaces.pair == pair.name) return surfaces.contactorSides;
    throw Error(ExitCode::mesh,
                format("the mesh holds no surfaces of contact pair '{}'", pair.name),
                "run fpmSetContact");
}

void addOwnFaces(ContactPassSetup& out, const Model& model, const std::vector<ElementSide>& sides)
{
    std::map<Index, std::vector<Index>> around;
    for (const ElementSide& side : sides) {
        const Quad quad = model.mesh.sideNodes(side);
        for (const Index node : quad) around[node].push_back(Index(out.ownFaceNode.size() / 4));
        out.ownFaceNode.insert(out.ownFaceNode.end(), quad.begin(), quad.end());
    }
    out.ownFaceStart.push_back(0);
    for (const Index node : out.contactor) {
        const std::vector<Index>& faces = around[node];
        out.ownFaces.insert(out.ownFaces.end(), faces.begin(), faces.end());
        out.ownFaceStart.push_back(Index(out.ownFaces.size()));
    }
}

/// Bodies of faces and contactors, where there are several or some may not meet.
void addComponents(ContactPassSetup& out,
                   const Model& model,
                   const ContactPair& pair,
                   const std::vector<ElementSide>& own,
                   const std::vector<ElementSide>& target)
{
    const auto bodyOf = [&](const ElementSide& side) { return model.mesh.partOf(side.element); };
    for (const ElementSide& side : target) out.faceComponent.push_back(bodyOf(side));
    const auto [least, most] =
        std::minmax_element(out.faceComponent.begin(), out.faceComponent.end());
    if (pair.kind != ContactKind::general
        && (*least == *most || pair.search == ContactSearch::closestParticle)) {
        out.faceComponent.clear();
        return;
    }
    std::map<Index, Index> body;
    for (const ElementSide& side : own)
        for (const Index node : model.mesh.sideNodes(side)) body[node] = bodyOf(side);
    for (const Index node : out.contactor) out.contactorComponent.push_back(body[node]);
    const std::size_t parts = model.parts.size();
    out.components = Index(parts);
    out.mayMeet.assign(parts * parts, 1);
    if (pair.kind == ContactKind::general)
        for (std::size_t a = 0; a < parts; ++a)
            for (std::size_t b = 0; b < parts; ++b)
                if (isRigid(model.parts[a].kind) && isRigid(model.parts[b].kind))
                    out.mayMeet[a * parts + b] = 0;
    for (const auto& [a, b] : pair.apart)
        out.mayMeet[std::size_t(a) * parts + std::size_t(b)] =
            out.mayMeet[std::size_t(b) * parts + std::size_t(a)] = 0;
    const std::size_t bodies =
        std::set<Index>(out.faceComponent.begin(), out.faceComponent.end()).size();
    const std::vector<Index> nodes = out.contactor;
    for (std::size_t slot = 1; slot < std::min<std::size_t>(bodies, maxSlots); ++slot)
        out.contactor.insert(out.contactor.end(), nodes.begin(), nodes.end());
}

/// Faces that are no partner of a contactor of the same body: those of all elements at the nodes of
/// its own faces, so that neither its surroundings nor the other side of a thin layer capture it.
void addExclusions(ContactPassSetup& out,
                   const Model& model,
                   const ContactPair& pair,
                   const std::vector<ElementSide>& target)
{
    const Mesh& mesh = model.mesh;
    std::vector<std::vector<Index>> faces(mesh.hexahedra.size()), elements(mesh.points.size());
    for (std::size_t face = 0; face < target.size(); ++face)
        faces[std::size_t(target[face].element)].push_back(Index(face));
    for (std::size_t element = 0; element < mesh.hexahedra.size(); ++element)
        for (const Index node : mesh.hexahedra[element])
            elements[std::size_t(node)].push_back(Index(element));
    out.excludedStart.push_back(0);
    for (std::size_t i = 0; i < std::size_t(out.nodeCount); ++i) {
        std::set<Index> excluded;
        for (Index k = out.ownFaceStart[i]; k < out.ownFaceStart[i + 1]; ++k)
            for (std::size_t corner = 0; corner < 4; ++corner) {
                const std::size_t own = 4 * std::size_t(out.ownFaces[std::size_t(k)]) + corner;
                for (const Index element : elements[std::size_t(out.ownFaceNode[own])])
                    excluded.insert(faces[std::size_t(element)].begin(),
                                    faces[std::size_t(element)].end());
            }
        out.excluded.insert(out.excluded.end(), excluded.begin(), excluded.end());
        requireExclusionPlaces(pair.name, out.excluded.size());
        out.excludedStart.push_back(Index(out.excluded.size()));
    }
}

bool differ(const std::vector<double>& stiffness)
{
    if (stiffness.empty()) return false;
    const auto [least, most] = std::minmax_element(stiffness.begin(), stiffness.end());
    return *most > (1 + 1e-9) * *least;
}

/// On a plane of symmetry a surface does not end: its other half goes on there.
void continueAtMirrors(ContactPassSetup& pass, const std::vector<MirrorPlane>& planes)
{
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        const Point& normal = planes[plane].normal;
        pass.mirrorNormal.insert(pass.mirrorNormal.end(), normal.begin(), normal.end());
        for (std::size_t edge = 0; edge < pass.neighbour.size(); ++edge) {
            const std::size_t first = edge / 4 * 4;
            const auto lies = [&](std::size_t corner) {
                return planes[plane].holds[std::size_t(pass.faceNode[first + corner % 4])];
            };
            // A face that lies in the plane as a whole has no edge that is its border.
            if (pass.neighbour[edge] == freeEdge && lies(edge) && lies(edge + 1)
                && !(lies(edge + 2) && lies(edge + 3)))
                pass.neighbour[edge] = mirrorEdge(Index(plane));
        }
    }
}

/// One pass: the nodes of `own` against the faces of `target`.
ContactPassSetup makePass(const SolverSetUp& data,
                          const Model& model,
                          const ContactPair& pair,
                          const std::vector<ElementSide>& own,
                          const std::vector<ElementSide>& target)
{
    ContactPassSetup out;
    out.search = pair.search;
    out.projection = pair.projection;
    out.law = pair;
    if (own.empty() || target.empty()) { // deletion has left nothing to touch
        out.ownFaceStart = {0};
        out.cellSize = 1;
        out.reach = 1e30;
        return out;
    }
    out.contactor = nodesOf(model.mesh, own);
    out.nodeCount = Index(out.contactor.size());
    out.forgives = pair.initialOverlap == InitialOverlap::offset
                   || pair.initialOverlap == InitialOverlap::ramp;
    out.fadeTime = pair.initialOverlap == InitialOverlap::ramp ? pair.rampTime : 0;
    addOwnFaces(out, model, own);
    double areas = 0;
    for (const ElementSide& side : target) {
        const Quad quad = model.mesh.sideNodes(side);
        out.faceNode.insert(out.faceNode.end(), quad.begin(), quad.end());
        const double a = area(model.mesh, side);
        areas += a;
        out.faceThickness.push_back(volume(model.mesh, side.element) / a);
    }
    out.meanFaceSize = std::sqrt(areas / double(target.size()));
    addTopology(out, model.mesh.points);
    continueAtMirrors(out, mirrorPlanes(model));
    if (pair.kind != ContactKind::pair) addExclusions(out, model, pair, target);
    addComponents(out, model, pair, own, target);
    addPenalty(out, data, model, pair, own, target);
    out.unequalFaces = differ(out.faceStiffness);
    out.mayLeave = data.elements.erodes;
    return out;
}

/// The passes of a pair: one, or two, and that of the edges.
void addPasses(SolverSetUp& data, const Model& model, std::size_t number)
{
    const ContactPair& pair = model.contactPairs[number];
    const std::vector<ElementSide>& own = ownSides(model, pair);
    if (pair.surface >= 0) {
        data.contact.passes.push_back(makeSurfacePair(data, model, pair, own));
        data.contact.passes.back().pair = number;
        return;
    }
    data.contact.passes.push_back(makePass(data, model, pair, own, pair.targetSides));
    data.contact.passes.back().pair = number;
    if (pair.passes == 2) {
        data.contact.passes.push_back(makePass(data, model, pair, pair.targetSides, own));
        data.contact.passes.back().pair = number;
        data.contact.passes.back().reversed = true;
    }
    if (pair.edges) addEdgePass(data, model, number, own);
}

/// Which kinematic passes a node is a contactor of, in their order.
void addSurfaceUses(SolverSetUp& data)
{
    ContactSetUp& contact = data.contact;
    contact.surfaceStart.clear();
    contact.surfaceUses.clear();
    std::map<Index, std::vector<SurfaceUse>> uses;
    for (std::size_t pass = 0; pass < contact.passes.size(); ++pass)
        for (std::size_t i = 0;
             contact.passes[pass].kinematic && i < contact.passes[pass].contactor.size(); ++i)
            uses[contact.passes[pass].contactor[i]].push_back({Index(pass), Index(i)});
    if (uses.empty()) return;
    contact.surfaceStart.push_back(0);
    for (Index node = 0; node < data.nodes.count; ++node) {
        if (const auto found = uses.find(node); found != uses.end())
            contact.surfaceUses.insert(contact.surfaceUses.end(), found->second.begin(),
                                       found->second.end());
        contact.surfaceStart.push_back(Index(contact.surfaceUses.size()));
    }
}

/// Power of two that takes sums of values up to `most` to below `room`.
double scaleFor(double room, double most)
{
    return most > 0 ? std::exp2(std::floor(std::log2(room / most))) : 1;
}

} // namespace

void addContact(SolverSetUp& data, const Model& model)
{
    if (data.contact.surfaces.empty()) // once: renewed contact finds them here
        for (const RigidSurface& surface : model.rigidSurfaces)
            data.contact.surfaces.push_back(surfaceShape(surface, data.nodes.amplitudeRows));
    double largestForce = 0, largestStiffness = 0;
    std::size_t contactors = 0;
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair)
        addPasses(data, model, pair);
    for (const ContactPassSetup& made : data.contact.passes) {
        if (made.kinematic) continue; // without springs
        contactors += made.contactor.size();
        const double stiffness = fpm::largestStiffness(made);
        double depth = made.deepest;
        for (const double thickness : made.faceThickness) depth = std::max(depth, thickness);
        // Damping at the speed that crosses the depth in one step, omega dt down to 2e-3 zeta.
        // Friction has a couple too, on faces down to a seventh as wide as the contactor is deep.
        const double most = 1 + 8 * made.law.friction + (made.law.normalDamping > 0 ? 1e3 : 0);
        largestForce = std::max(largestForce, stiffness * depth * most);
        largestStiffness = std::max(largestStiffness, 2 * stiffness * dampingLimit(made.law));
        data.contact.nodes.insert(data.contact.nodes.end(), made.contactor.begin(),
                                  made.contactor.end());
        data.contact.nodes.insert(data.contact.nodes.end(), made.target.begin(), made.target.end());
    }
    std::sort(data.contact.nodes.begin(), data.contact.nodes.end());
    data.contact.nodes.erase(std::unique(data.contact.nodes.begin(), data.contact.nodes.end()),
                             data.contact.nodes.end());
    data.contact.numberOf.assign(std::size_t(data.nodes.count), -1);
    for (std::size_t i = 0; i < data.contact.nodes.size(); ++i) {
        const std::size_t node = std::size_t(data.contact.nodes[i]);
        data.contact.numberOf[node] = Index(i);
    }
    addSurfaceUses(data);
    // Were every contactor on one node, with the largest force, the sum would stay below 2^62.
    const double room = std::exp2(61 - std::ceil(std::log2(double(contactors + 1))));
    data.contact.scale.toFixed = scaleFor(room, largestForce);
    data.contact.scale.fromFixed = 1 / data.contact.scale.toFixed;
    data.contact.scale.toSpring = scaleFor(room, largestStiffness);
    data.contact.scale.fromSpring = 1 / data.contact.scale.toSpring;
}

} // namespace fpm
