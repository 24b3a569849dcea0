#include "solver/contact/EdgeSetUp.h"

#include "kernels/contact/broad/CellLists.h"
#include "kernels/contact/edges/EdgePassView.h"
#include "mesh/Quality.h"
#include "mesh/SharpEdges.h"
#include "mesh/Surface.h"
#include "mesh/Vector.h"
#include "solver/contact/MirrorPlanes.h"
#include "solver/contact/Penalties.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fpm {

namespace {

Point alongOf(const Mesh& mesh, const SharpEdge& edge)
{
    return vector::difference(mesh.points[std::size_t(edge.nodes[1])],
                              mesh.points[std::size_t(edge.nodes[0])]);
}

/// Which segment goes on at either end, as edgeNext: of the same side and body, and the one that
/// bends least, by less than 60 degrees, seen from both.
std::vector<Index>
continuations(const Mesh& mesh, const std::vector<SharpEdge>& edges, const ContactPassSetup& pass)
{
    std::map<Index, std::vector<Index>> at; // ends, 2 * segment + end, of a node
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t end = 0; end < 2; ++end)
            at[edges[i].nodes[end]].push_back(Index(2 * i + end));
    const auto group = [&](Index end) {
        return std::pair{end / 2 < pass.firstTarget, pass.faceComponent[std::size_t(end / 2)]};
    };
    const auto outwards = [&](Index end) { // from the node along the segment
        const Point along = alongOf(mesh, edges[std::size_t(end / 2)]);
        return vector::scaled(along, (end & 1 ? -1 : 1) / vector::length(along));
    };
    std::vector<Index> best(2 * edges.size(), -1);
    for (const auto& [node, ends] : at)
        for (const Index end : ends) {
            double least = -0.5;
            for (const Index other : ends) {
                if (other / 2 == end / 2 || group(other) != group(end)) continue;
                const double cosine = vector::dot(outwards(end), outwards(other));
                if (!(cosine < least)) continue;
                least = cosine;
                best[std::size_t(end)] = other;
            }
        }
    std::vector<Index> next(best.size(), -1);
    for (std::size_t end = 0; end < best.size(); ++end)
        if (best[end] >= 0 && best[std::size_t(best[end])] == Index(end)) next[end] = best[end];
    return next;
}

/// Segments that share an element with one of the same surface, as faces do (addExclusions).
void addExclusions(ContactPassSetup& out, const Mesh& mesh, const std::vector<SharpEdge>& edges)
{
    std::map<Index, std::vector<Index>> segments; // of a node
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t end = 0; end < 2; ++end) segments[edges[i].nodes[end]].push_back(Index(i));
    std::map<Index, std::vector<Index>> elements; // of such a node
    for (std::size_t element = 0; element < mesh.hexahedra.size(); ++element)
        for (const Index node : mesh.hexahedra[element])
            if (segments.count(node) > 0) elements[node].push_back(Index(element));
    out.excludedStart.push_back(0);
    for (const SharpEdge& edge : edges) {
        std::set<Index> excluded;
        for (std::size_t end = 0; end < 2; ++end)
            for (const Index element : elements[edge.nodes[end]])
                for (const Index node : mesh.hexahedra[std::size_t(element)])
                    if (const auto found = segments.find(node); found != segments.end())
                        excluded.insert(found->second.begin(), found->second.end());
        out.excluded.insert(out.excluded.end(), excluded.begin(), excluded.end());
        out.excludedStart.push_back(Index(out.excluded.size()));
    }
}

/// The least thickness behind each segment, and the mean size of the faces at them.
void addSizes(ContactPassSetup& out, const Mesh& mesh, const std::vector<SharpEdge>& edges)
{
    double areas = 0, lengths = 0, count = 0;
    for (const SharpEdge& edge : edges) {
        double thickness = 1e300;
        for (const ElementSide& side : edge.sides) {
            const double a = area(mesh, side);
            thickness = std::min(thickness, volume(mesh, side.element) / a);
            areas += a;
            ++count;
        }
        out.faceThickness.push_back(thickness);
        lengths += vector::length(alongOf(mesh, edge));
    }
    out.meanFaceSize = std::sqrt(areas / count);
    out.reach = 0.25 * out.meanFaceSize;
    out.queryHalf = 0.5 * lengths / double(edges.size());
}

/// Cells for boxes of the segments as InsertEdge enters them; they may stretch by a fifth.
void addCells(ContactPassSetup& out, const Mesh& mesh, const std::vector<SharpEdge>& edges)
{
    double narrowest = 1e300, widest = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double margin = std::max(out.reach, 0.5 * (out.faceThickness[i] + out.reach));
        const double wide =
            1.2 * vector::length(alongOf(mesh, edges[i])) + 2 * (margin + out.queryHalf);
        narrowest = std::min(narrowest, wide);
        widest = std::max(widest, wide);
    }
    out.cellSize = 0.5 * narrowest;
    out.levels =
        std::min(CellLists::mostLevels, 1 + Index(std::ceil(std::log2(widest / narrowest))));
}

/// Where the ends of the segments are contactors in the passes of nodes against faces.
void addNodePasses(ContactPassSetup& out, const ContactSetUp& contact)
{
    std::size_t place = 0;
    for (std::size_t number = 0; number < contact.passes.size(); ++number) {
        const ContactPassSetup& pass = contact.passes[number];
        if (pass.pair != out.pair || place == out.nodePasses.size()) continue;
        std::map<Index, Index> contactor;
        for (Index i = 0; i < pass.nodeCount; ++i) contactor[pass.contactor[std::size_t(i)]] = i;
        ContactPassSetup::NodePass& of = out.nodePasses[place++];
        of.number = Index(number);
        for (std::size_t i = 0; i < out.edgeNode.size(); i += 6)
            for (std::size_t end = 0; end < 2; ++end) {
                const auto found = contactor.find(out.edgeNode[i + end]);
                of.contactor.push_back(found == contactor.end() ? -1 : found->second);
            }
    }
}

/// Contactors are the slots of the segments below `own`.
void addContactors(ContactPassSetup& out,
                   const Mesh& mesh,
                   const std::vector<SharpEdge>& edges,
                   const ContactPassSetup& faces,
                   std::size_t own)
{
    for (const SharpEdge& edge : edges) {
        out.edgeNode.insert(out.edgeNode.end(), edge.nodes.begin(), edge.nodes.end());
        out.target.insert(out.target.end(), edge.nodes.begin(), edge.nodes.begin() + 2);
        out.faceComponent.push_back(mesh.partOf(edge.sides.front().element));
    }
    out.nodeCount = Index(own);
    for (int slot = 0; slot < edgeSlots; ++slot)
        for (std::size_t i = 0; i < own; ++i) out.contactor.push_back(edges[i].nodes[0]);
    out.contactorComponent = out.faceComponent;
    out.contactorComponent.resize(own);
    out.mayMeet = faces.mayMeet;
    out.components = faces.components;
}

} // namespace

void addEdgePass(SolverSetUp& data,
                 const Model& model,
                 std::size_t number,
                 const std::vector<ElementSide>& own)
{
    const ContactPair& pair = model.contactPairs[number];
    const std::vector<MirrorPlane> planes = mirrorPlanes(model);
    std::vector<const std::vector<bool>*> mirrors;
    for (const MirrorPlane& plane : planes) mirrors.push_back(&plane.holds);
    std::vector<SharpEdge> edges = sharpEdges(model.mesh, own, mirrors);
    const std::size_t ownCount = edges.size();
    ContactPassSetup out;
    out.pair = number;
    out.ofEdges = true;
    out.law = pair;
    if (pair.kind == ContactKind::pair) {
        const std::vector<SharpEdge> target = sharpEdges(model.mesh, pair.targetSides, mirrors);
        edges.insert(edges.end(), target.begin(), target.end());
        out.firstTarget = Index(ownCount);
    }
    if (ownCount == 0 || edges.size() == std::size_t(out.firstTarget)) {
        if (!data.elements.erodes) return; // else deletion may make some: the pass is there
        out.cellSize = 1;
        out.reach = 1e30;
        data.contact.passes.push_back(std::move(out));
        return;
    }
    const ContactPassSetup& faces = data.contact.passes.back();
    out.forgives = faces.forgives;
    out.fadeTime = faces.fadeTime;
    addContactors(out, model.mesh, edges, faces, ownCount);
    addSizes(out, model.mesh, edges);
    addCells(out, model.mesh, edges);
    out.edgeNext = continuations(model.mesh, edges, out);
    if (pair.kind != ContactKind::pair) addExclusions(out, model.mesh, edges);
    addEdgePenalty(out, data, model, pair, edges);
    addNodePasses(out, data.contact);
    out.mayLeave = data.elements.erodes;
    data.contact.passes.push_back(std::move(out));
}

} // namespace fpm
