#include "model/ContactReader.h"

#include "base/Format.h"
#include "model/ContactLawReader.h"
#include "model/Names.h"
#include "model/PointAlgebra.h"

namespace fpm {

namespace {

Region readBox(const Dictionary& entry)
{
    const auto corners = entry.tailRows("within", 3);
    if (corners.size() != 2)
        entry.fail("within", "a box needs two corners", "such as: within box ((0 0 0) (10 10 5));");
    Region region{Region::Kind::box, {}, {}, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        region.first[axis] = corners[0][axis];
        region.second[axis] = corners[1][axis];
        if (region.first[axis] > region.second[axis])
            entry.fail("within",
                       format("the first corner {} is not below the second {}",
                              pointText({corners[0][0], corners[0][1], corners[0][2]}),
                              pointText({corners[1][0], corners[1][1], corners[1][2]})),
                       "give the lower corner first");
    }
    return region;
}

Region readCylinder(const Dictionary& entry)
{
    const auto v = entry.tailNumbers("within");
    if (v.size() != 7)
        entry.fail("within", "a cylinder needs the two ends of its axis and a radius",
                   "such as: within cylinder ((0 0 0) (0 0 10) 5);");
    Region region{Region::Kind::cylinder, {v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6]};
    if (region.first == region.second)
        entry.fail("within", "the axis of the cylinder has no length");
    if (region.radius <= 0)
        entry.fail("within", "the radius must be > 0, it is " + toText(region.radius, 6));
    return region;
}

SurfaceEntry readSurface(const Dictionary& entry, const std::string& name)
{
    SurfaceEntry surface;
    surface.name = name;
    const bool hasPart = entry.has("part");
    if (hasPart == entry.has("set"))
        entry.fail(hasPart ? "set" : "part",
                   hasPart ? "both 'part' and 'set' are given" : "the surface starts from nothing",
                   "give 'part <part>;' for its skin, or 'set <side set>;'");
    (hasPart ? surface.part : surface.set) = entry.word(hasPart ? "part" : "set");

    if (entry.has("facing")) {
        const Point direction = entry.vector("facing");
        const double size = length(direction);
        if (size == 0) entry.fail("facing", "the direction (0 0 0) points nowhere");
        surface.facing = along({0, 0, 0}, 1 / size, direction);
    }
    if (entry.has("within")) {
        const std::string shape = entry.leadingWord("within");
        if (shape == "box")
            surface.within = readBox(entry);
        else if (shape == "cylinder")
            surface.within = readCylinder(entry);
        else
            entry.fail("within", "unknown region '" + shape + "'",
                       nameAdvice(shape, {"box", "cylinder"}, "valid"));
    }
    return surface;
}

/// What pairs and general contact have in common. `edges`: the default of that entry; `analytic`:
/// against a surface without a mesh.
void readOptions(PairEntry& pair, const Dictionary& entry, bool edges, bool analytic)
{
    static_cast<ContactLaw&>(pair) = readContactLaw(entry, analytic);
    pair.edges = entry.switchOr("edges", edges);
    const std::string overlap =
        entry.choiceOr("initialOverlap", "offset", {"report", "offset", "ramp", "move"});
    pair.initialOverlap = overlap == "report" ? InitialOverlap::report
                          : overlap == "ramp" ? InitialOverlap::ramp
                          : overlap == "move" ? InitialOverlap::move
                                              : InitialOverlap::offset;
    if (pair.initialOverlap == InitialOverlap::ramp)
        pair.rampTime = entry.number("rampTime", positive());
}

PairEntry readPair(const Dictionary& entry, const std::string& name, const ContactEntries& surfaces)
{
    PairEntry pair;
    pair.name = name;
    pair.contactor = entry.word("contactor");
    pair.target = entry.word("target");
    readOptions(pair, entry, false, surfaces.rigidSurface(pair.target) >= 0);
    pair.search = entry.choiceOr("search", "faces", {"faces", "closestParticle"}) == "faces"
                      ? ContactSearch::faces
                      : ContactSearch::closestParticle;
    pair.projection = entry.choiceOr("projection", "tracked", {"tracked", "cold"}) == "cold"
                          ? ContactProjection::cold
                          : ContactProjection::tracked;
    pair.passes = entry.choiceOr("passes", "one", {"one", "two"}) == "two" ? 2 : 1;
    return pair;
}

PairEntry readGeneral(const Dictionary& contactDict)
{
    PairEntry general;
    general.name = generalContact;
    general.edges = true;
    if (contactDict.isDictionary(generalContact)) {
        const Dictionary entry = contactDict.sub(generalContact);
        readOptions(general, entry, true, false);
        if (general.initialOverlap == InitialOverlap::move)
            entry.fail("initialOverlap", "in general contact nothing says which body should move",
                       "give the two bodies a pair of their own with 'initialOverlap move;'");
    } else if (!contactDict.isBare(generalContact))
        contactDict.fail(generalContact, "general contact has no value",
                         "write 'general;', or 'general { friction 0.2; }'");
    return general;
}

std::string exactText(const Point& point)
{
    return format(" {} {} {}", toText(point[0]), toText(point[1]), toText(point[2]));
}

} // namespace

bool Region::contains(const Point& point) const
{
    if (kind == Kind::box) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (point[axis] < first[axis] || point[axis] > second[axis]) return false;
        return true;
    }
    const Point axis = difference(second, first), offset = difference(point, first);
    const double share = dot(offset, axis) / dot(axis, axis);
    return share >= 0 && share <= 1 && length(along(offset, -share, axis)) <= radius;
}

ContactEntries readContactEntries(const Dictionary& contactDict)
{
    ContactEntries entries;
    const Dictionary surfaces = contactDict.subOrEmpty("surfaces");
    for (const std::string& name : surfaces.keys()) {
        const Dictionary entry = surfaces.sub(name);
        if (entry.has("type"))
            entries.rigidSurfaces.push_back(readRigidSurface(entry, name));
        else
            entries.surfaces.push_back(readSurface(entry, name));
    }

    const bool general = contactDict.has(generalContact);
    if (general) entries.general = readGeneral(contactDict);
    const Dictionary pairs = general ? contactDict.subOrEmpty("pairs") : contactDict.sub("pairs");
    for (const std::string& name : pairs.keys()) {
        if (name == generalContact)
            pairs.fail(name, "'general' is the name of contact of all bodies with all",
                       "write 'general;' outside of 'pairs', or give the pair another name");
        entries.pairs.push_back(readPair(pairs.sub(name), name, entries));
        if (!isFileName(name))
            pairs.fail(name, "'" + name + "' cannot be the name of a file under postProcessing",
                       "use letters, digits and _ . + -, at most 64, no leading dot");
    }
    contactDict.requireAllUsed();
    return entries;
}

Index ContactEntries::rigidSurface(const std::string& name) const
{
    for (std::size_t i = 0; i < rigidSurfaces.size(); ++i)
        if (rigidSurfaces[i].name == name) return Index(i);
    return -1;
}

std::string surfaceText(const ContactEntries& entries)
{
    std::string text;
    for (const SurfaceEntry& surface : entries.surfaces) {
        text += format("surface {} part {} set {}", surface.name, surface.part, surface.set);
        if (surface.facing) text += " facing" + exactText(*surface.facing);
        if (surface.within) {
            const Region& region = *surface.within;
            text += region.kind == Region::Kind::box ? " box" : " cylinder";
            text += exactText(region.first) + exactText(region.second);
            text += format(" {}", toText(region.radius));
        }
        text += "\n";
    }
    for (const PairEntry& pair : entries.pairs)
        text += format("pair {} {} {}{}\n", pair.name, pair.contactor, pair.target,
                       pair.initialOverlap == InitialOverlap::move ? " move" : "",
                       entries.rigidSurface(pair.target) >= 0 ? " analytic" : "");
    if (entries.general) text += "general\n";
    return text;
}

} // namespace fpm
