#include "model/ContactSurface.h"

#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/Names.h"
#include "model/NodeSelection.h"
#include "model/PointAlgebra.h"

#include <algorithm>

namespace fpm {

namespace {

std::vector<std::string> partNames(const Mesh& mesh)
{
    std::vector<std::string> names;
    for (const MeshPart& part : mesh.parts) names.push_back(part.name);
    return names;
}

/// The sides a named surface starts from, before it is narrowed.
std::vector<ElementSide>
startingSides(const Mesh& mesh, const SurfaceEntry& surface, const Dictionary& place)
{
    if (!surface.part.empty()) {
        const Index part = mesh.findPart(surface.part);
        if (part < 0)
            place.fail("part", "the mesh has no part '" + surface.part + "'",
                       nameAdvice(surface.part, partNames(mesh), "parts of the mesh"));
        return skin(mesh, part);
    }
    const auto found = mesh.sideSets.find(surface.set);
    if (found == mesh.sideSets.end())
        place.fail("set", "the mesh has no side set '" + surface.set + "'",
                   nameAdvice(surface.set, keysOf(mesh.sideSets), "side sets of the mesh"));
    return found->second;
}

template <class Condition>
std::size_t keepOnly(std::vector<ElementSide>& sides, const Condition& condition)
{
    std::erase_if(sides, [&](const ElementSide& side) { return !condition(side); });
    return sides.size();
}

std::vector<ElementSide>
namedSides(const Mesh& mesh, const SurfaceEntry& surface, const Dictionary& place)
{
    constexpr double cosine45 = 0.70710678118654752;
    std::vector<ElementSide> sides = startingSides(mesh, surface, place);
    std::string story =
        format("{} sides of {} '{}'", sides.size(), surface.part.empty() ? "side set" : "part",
               surface.part.empty() ? surface.set : surface.part);
    if (surface.facing) {
        const std::size_t left = keepOnly(sides, [&](const ElementSide& side) {
            return dot(normal(mesh, side), *surface.facing) > cosine45;
        });
        story += format(", of which {} face {}", left, pointText(*surface.facing));
    }
    if (surface.within) {
        const std::size_t left = keepOnly(sides, [&](const ElementSide& side) {
            return surface.within->contains(centre(mesh, side));
        });
        story += format(", of which {} lie within the {}", left,
                        surface.within->kind == Region::Kind::box ? "box" : "cylinder");
    }
    if (sides.empty())
        place.fail(surface.within   ? "within"
                   : surface.facing ? "facing"
                                    : "set",
                   "surface '" + surface.name + "' is empty: " + story,
                   "widen 'facing' or 'within', or choose another part or set");
    if (!surface.set.empty()) refuseInnerSides(place, "set", mesh, sides, "contact");
    return sides;
}

} // namespace

std::vector<ElementSide> contactSides(const Mesh& mesh,
                                      const ContactEntries& entries,
                                      const PairEntry& pair,
                                      const std::string& key,
                                      const Dictionary& contactDict)
{
    const std::string& name = key == "contactor" ? pair.contactor : pair.target;
    for (const SurfaceEntry& surface : entries.surfaces)
        if (surface.name == name)
            return namedSides(mesh, surface, contactDict.sub("surfaces").sub(name));
    if (const Index part = mesh.findPart(name); part >= 0) return skin(mesh, part);

    const Dictionary place = contactDict.sub("pairs").sub(pair.name);
    if (entries.rigidSurface(name) >= 0)
        place.fail(key, "'" + name + "' is an analytic surface: it has no nodes of its own",
                   "let it be the target, and the body the contactor");
    if (const auto set = mesh.sideSets.find(name); set != mesh.sideSets.end()) {
        if (set->second.empty()) place.fail(key, "side set '" + name + "' is empty");
        refuseInnerSides(place, key, mesh, set->second, "contact");
        return set->second;
    }
    std::vector<std::string> names;
    for (const SurfaceEntry& surface : entries.surfaces) names.push_back(surface.name);
    for (const RigidSurface& surface : entries.rigidSurfaces) names.push_back(surface.name);
    for (const std::string& part : partNames(mesh)) names.push_back(part);
    for (const std::string& set : keysOf(mesh.sideSets)) names.push_back(set);
    place.fail(key, "no surface, part or side set is called '" + name + "'",
               nameAdvice(name, names, "there are"));
}

} // namespace fpm
