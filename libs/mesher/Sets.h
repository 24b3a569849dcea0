#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "mesher/Bodies.h"

#include <map>
#include <string>
#include <vector>

namespace fpm {

/// An entry of `sets`, read but not yet looked up in a mesh.
struct SetEntry {
    enum class Kind { plane, box, unite, point } kind = Kind::plane;
    std::string name;
    Dictionary dictionary;           ///< for messages
    std::vector<std::string> bodies; ///< plane, box: entries or parts; empty = all
    Point point{};                   ///< on the plane; lower corner of the box; position
    Point second{};                  ///< normal of the plane (unit); upper corner of the box
    double tolerance = 0;            ///< plane; 0 = a millionth of the mesh's extent
    std::vector<std::string> sets;   ///< union
    std::string body;                ///< point; empty = any
};

/// Reads the entries of `sets`; throws InputError.
std::vector<SetEntry> readSets(const Dictionary& sets);

/// Makes the sets in the mesh and reports their sizes. Throws InputError at the entry: an unknown
/// body or set, a name that is taken, an empty set, a union of itself.
void makeSets(const std::vector<SetEntry>& entries, MeshedBodies& bodies, Log& log);

} // namespace fpm
