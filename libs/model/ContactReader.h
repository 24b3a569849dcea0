#pragma once

#include "dictionary/Dictionary.h"
#include "model/Model.h"

#include <optional>

namespace fpm {

/// A box or cylinder of system/contactDict; a surface keeps the sides whose centre lies in it.
struct Region {
    enum class Kind { box, cylinder } kind = Kind::box;
    Point first{}, second{}; ///< corners of the box, ends of the cylinder's axis
    double radius = 0;       ///< of the cylinder
    bool contains(const Point& point) const;
};

/// system/contactDict, surfaces, one entry.
struct SurfaceEntry {
    std::string name;
    std::string part, set;       ///< one of them is empty
    std::optional<Point> facing; ///< unit vector
    std::optional<Region> within;
};

/// system/contactDict, pairs, one entry.
struct PairEntry : ContactLaw {
    std::string name;
    std::string contactor, target; ///< a surface, a part or a side set; target also analytic
    ContactSearch search = ContactSearch::faces;
    ContactProjection projection = ContactProjection::tracked;
    int passes = 1;
    bool edges = false;
    InitialOverlap initialOverlap = InitialOverlap::offset;
    double rampTime = 0;
};

/// Name of general contact among the pairs: in the mesh file, under postProcessing, in messages.
inline const std::string generalContact = "general";

struct ContactEntries {
    std::vector<SurfaceEntry> surfaces;
    std::vector<RigidSurface> rigidSurfaces;
    std::vector<PairEntry> pairs;
    Index rigidSurface(const std::string& name) const; ///< its number, -1: none of that name
    std::optional<PairEntry> general; ///< all bodies against all; no contactor, no target
};
ContactEntries readContactEntries(const Dictionary& contactDict);

/// What decides which nodes and sides the pairs have, apart from the mesh: the same text for the
/// same surfaces, whatever the layout of the dictionary, its friction and its penalty scales.
std::string surfaceText(const ContactEntries& entries);

} // namespace fpm
