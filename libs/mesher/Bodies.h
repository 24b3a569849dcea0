#pragma once

#include "case/Case.h"
#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"
#include "mesher/Shape.h"

#include <map>
#include <string>
#include <vector>

namespace fpm {

/// The entries of `bodies`, read and checked, in the order of the dictionary.
struct Bodies {
    struct Entry {
        std::string name;
        std::vector<Shape> shapes; ///< empty for a file
        std::string file;          ///< relative to the case; empty otherwise
    };
    std::vector<Entry> entries;

    /// `refinement` cuts every cell of every body; files cannot be refined. Throws InputError.
    static Bodies read(const Dictionary& bodies, int refinement);
};

/// The bodies as one mesh, and which parts came from which entry.
struct MeshedBodies {
    Mesh mesh;
    std::map<std::string, std::vector<std::string>> partsOfEntry;
};

/// Meshes body after body and reports each on a line of `log`.
MeshedBodies meshBodies(const Bodies& bodies, const Case& theCase, bool allowGeo, Log& log);

} // namespace fpm
