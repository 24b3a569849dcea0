#include "run/Bodies.h"

#include <algorithm>
#include <numeric>

namespace fpm {

Bodies::Bodies(const Model& model) : model_(model)
{
    join();
    held_.assign(count(), false);
    concerned_.assign(count(), false);
    addConditions();
    addContact();
}

/// Parts with a node in common are one body.
void Bodies::join()
{
    const Mesh& mesh = model_.mesh;
    std::vector<std::size_t> root(mesh.parts.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto find = [&](std::size_t part) {
        while (root[part] != part) part = root[part];
        return part;
    };
    std::vector<Index> partOf(mesh.points.size(), -1);
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        const Index first = mesh.parts[part].firstElement;
        for (Index e = first; e < first + mesh.parts[part].elementCount; ++e)
            for (const Index node : mesh.hexahedra[std::size_t(e)]) {
                Index& owner = partOf[std::size_t(node)];
                if (owner < 0) owner = Index(part);
                const std::size_t a = find(std::size_t(owner)), b = find(part);
                root[std::max(a, b)] = std::min(a, b);
            }
    }
    bodyOf_.resize(mesh.parts.size());
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        if (find(part) == part) {
            bodyOf_[part] = parts_.size();
            parts_.emplace_back();
        } else
            bodyOf_[part] = bodyOf_[find(part)];
        parts_[bodyOf_[part]].push_back(part);
    }
    nodes_.resize(parts_.size());
    for (std::size_t node = 0; node < partOf.size(); ++node) { // each is some element's
        nodeBody_.push_back(bodyOf_[std::size_t(std::max<Index>(0, partOf[node]))]);
        nodes_[nodeBody_.back()].push_back(Index(node));
    }
}

void Bodies::concern(std::size_t body, bool holds)
{
    concerned_[body] = true;
    if (holds) held_[body] = true;
}

void Bodies::concern(const std::vector<Index>& nodes, bool holds)
{
    for (const Index node : nodes) concern(nodeBody_[std::size_t(node)], holds);
}

void Bodies::addConditions()
{
    for (std::size_t part = 0; part < model_.parts.size(); ++part)
        if (model_.parts[part].kind == PartKind::rigidPrescribed) held_[bodyOf_[part]] = true;
    for (const BoundaryCondition& condition : model_.boundaryConditions) {
        const bool holds = !condition.isLoad();
        concern(condition.nodes, holds);
        if (condition.part >= 0) concern(bodyOf_[std::size_t(condition.part)], holds);
        for (const Index part : condition.parts) concern(bodyOf_[std::size_t(part)], holds);
        for (const std::size_t body : bodiesOf(condition.sides)) concern(body, holds);
    }
    for (const InitialVelocity& velocity : model_.initialVelocities) concern(velocity.nodes, false);
}

std::set<std::size_t> Bodies::bodiesOf(const std::vector<ElementSide>& sides) const
{
    std::set<std::size_t> out;
    for (const ElementSide& side : sides)
        out.insert(bodyOf_[std::size_t(model_.mesh.partOf(side.element))]);
    return out;
}

void Bodies::addContact()
{
    for (const ContactPair& pair : model_.contactPairs)
        for (const ContactSurfaces& surfaces : model_.mesh.contact) {
            if (surfaces.pair != pair.name) continue;
            const std::set<std::size_t> one = bodiesOf(surfaces.contactorSides),
                                        other = bodiesOf(surfaces.targetSides);
            for (const std::size_t body : one) concern(body, false);
            for (const std::size_t body : other) concern(body, false);
            if (pair.kind == ContactKind::general)
                general_ = true; // those kept apart have pairs of their own
            else
                for (const std::size_t a : one)
                    for (const std::size_t b : other) meet_.insert(std::minmax(a, b));
        }
}

bool Bodies::mayMeet(std::size_t a, std::size_t b) const
{
    return general_ || meet_.count(std::minmax(a, b)) > 0;
}

std::string Bodies::name(std::size_t body) const
{
    std::string names;
    for (const std::size_t part : parts_[body])
        names += (names.empty() ? "" : ", ") + model_.parts[part].name;
    return (parts_[body].size() > 1 ? "parts " : "part ") + names;
}

} // namespace fpm
