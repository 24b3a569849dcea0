#include "solver/contact/SurfaceErosion.h"

#include "mesh/Surface.h"
#include "solver/elements/ModelSizes.h"

#include <algorithm>
#include <map>

namespace fpm {

namespace {

/// Elements across the sides of every element, within its part.
std::vector<Index> neighboursOf(const Mesh& mesh)
{
    struct Entry {
        Quad nodes; ///< ascending
        ElementSide side;
    };
    std::vector<Index> neighbours(6 * mesh.hexahedra.size(), -1);
    for (const MeshPart& part : mesh.parts) {
        std::vector<Entry> entries;
        for (Index e = part.firstElement; e < part.firstElement + part.elementCount; ++e)
            for (Index side = 0; side < 6; ++side) {
                Entry entry{mesh.sideNodes({e, side}), {e, side}};
                std::ranges::sort(entry.nodes);
                entries.push_back(entry);
            }
        std::ranges::sort(entries, {}, &Entry::nodes);
        for (std::size_t i = 1; i < entries.size(); ++i) {
            if (entries[i].nodes != entries[i - 1].nodes) continue;
            const ElementSide a = entries[i - 1].side, b = entries[i].side;
            neighbours[std::size_t(6 * a.element + a.side)] = b.element;
            neighbours[std::size_t(6 * b.element + b.side)] = a.element;
        }
    }
    return neighbours;
}

const ContactSurfaces& surfacesOf(const Mesh& mesh, const std::string& pair)
{
    return *std::ranges::find(mesh.contact, pair, &ContactSurfaces::pair);
}

/// Segments are the same where their nodes are: all six, so that the wedge is.
PassRenewal comparedEdges(const ContactPassSetup& before, const ContactPassSetup& after)
{
    PassRenewal out;
    const auto nodesOf = [](const ContactPassSetup& pass, std::size_t segment) {
        return std::vector<Index>(&pass.edgeNode[6 * segment], &pass.edgeNode[6 * segment] + 6);
    };
    std::map<std::vector<Index>, Index> known;
    for (std::size_t i = 0; i < before.edgeNode.size() / 6; ++i)
        known[nodesOf(before, i)] = Index(i);
    out.face.assign(before.edgeNode.size() / 6, -1);
    std::vector<Index> old;
    for (std::size_t i = 0; i < after.edgeNode.size() / 6; ++i) {
        const auto found = known.find(nodesOf(after, i));
        old.push_back(found == known.end() ? -1 : found->second);
        if (old.back() >= 0) out.face[std::size_t(old.back())] = Index(i);
    }
    for (std::size_t i = 0; i < after.contactor.size(); ++i) {
        const Index segment = old[i % std::size_t(after.nodeCount)],
                    slot = Index(i) / after.nodeCount;
        const bool stays = segment >= 0 && segment < before.nodeCount;
        out.contactor.push_back(stays ? slot * before.nodeCount + segment : -1);
    }
    return out;
}

} // namespace

SurfaceErosion::SurfaceErosion(const Model& model) : neighbours_(neighboursOf(model.mesh))
{
    model_.mesh = model.mesh;
    model_.parts = model.parts;
    model_.contactPairs = model.contactPairs;
    model_.boundaryConditions = model.boundaryConditions;
    for (const ContactPair& pair : model_.contactPairs)
        original_.push_back({pair.name, pair.contactorNodes,
                             surfacesOf(model.mesh, pair.name).contactorSides, pair.targetSides});
}

Index SurfaceErosion::neighbour(const ElementSide& side) const
{
    return neighbours_[std::size_t(6 * side.element + side.side)];
}

std::vector<ElementSide> SurfaceErosion::renewedSides(const std::vector<ElementSide>& original,
                                                      const std::vector<bool>& deleted) const
{
    std::vector<ElementSide> sides;
    std::vector<Index> queue;
    std::vector<bool> visited(deleted.size(), false);
    const auto visit = [&](Index element) {
        if (visited[std::size_t(element)]) return;
        visited[std::size_t(element)] = true;
        queue.push_back(element);
    };
    for (const ElementSide& side : original)
        if (deleted[std::size_t(side.element)])
            visit(side.element);
        else
            sides.push_back(side);
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (Index side = 0; side < 6; ++side) {
            const Index other = neighbour({queue[next], side});
            if (other < 0) continue;
            if (deleted[std::size_t(other)]) {
                visit(other);
                continue;
            }
            for (Index facing = 0; facing < 6; ++facing)
                if (neighbour({other, facing}) == queue[next]) sides.push_back({other, facing});
        }
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return sides;
}

bool SurfaceErosion::renewContact(SolverSetUp& data, const std::vector<bool>& deleted)
{
    bool changed = false;
    for (std::size_t i = 0; i < original_.size(); ++i) {
        ContactPair& pair = model_.contactPairs[i];
        ContactSurfaces& surfaces =
            *std::ranges::find(model_.mesh.contact, pair.name, &ContactSurfaces::pair);
        const std::vector<ElementSide> contactor =
                                           renewedSides(original_[i].contactorSides, deleted),
                                       target = renewedSides(original_[i].targetSides, deleted);
        if (contactor == surfaces.contactorSides && target == pair.targetSides) continue;
        changed = true;
        surfaces.contactorSides = contactor;
        pair.contactorNodes = nodesOf(model_.mesh, contactor);
        pair.targetSides = target;
    }
    if (!changed) return false;
    requirePlaces(sizesOf(model_)); // walls of holes join the surfaces
    data.contact.passes.clear();
    data.contact.nodes.clear();
    addContact(data, model_);
    return true;
}

PassRenewal compared(const ContactPassSetup& before, const ContactPassSetup& after)
{
    if (after.ofEdges) return comparedEdges(before, after);
    PassRenewal out;
    using Slot = std::pair<Index, Index>; // a node has a contactor for each body it may meet
    const auto slotOf = [](const ContactPassSetup& pass, std::size_t i) {
        return Slot{pass.contactor[i], Index(i) / pass.nodeCount};
    };
    std::map<Slot, Index> contactors;
    for (std::size_t i = 0; i < before.contactor.size(); ++i)
        contactors[slotOf(before, i)] = Index(i);
    for (std::size_t i = 0; i < after.contactor.size(); ++i) {
        const auto found = contactors.find(slotOf(after, i));
        out.contactor.push_back(found == contactors.end() ? -1 : found->second);
    }
    const auto corners = [](const ContactPassSetup& pass, std::size_t face) {
        const Index* nodes = &pass.faceNode[4 * face];
        return Quad{nodes[0], nodes[1], nodes[2], nodes[3]};
    };
    std::map<Quad, Index> faces;
    for (std::size_t face = 0; face < after.faceNode.size() / 4; ++face)
        faces[corners(after, face)] = Index(face);
    for (std::size_t face = 0; face < before.faceNode.size() / 4; ++face) {
        const auto found = faces.find(corners(before, face));
        out.face.push_back(found == faces.end() ? -1 : found->second);
    }
    return out;
}

} // namespace fpm
