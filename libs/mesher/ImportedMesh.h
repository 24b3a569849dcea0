#pragma once

#include "mesher/Gmsh.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fpm {

/// A physical group of a Gmsh file, in node and cell numbers of ImportedMesh.
struct PhysicalGroup {
    std::int64_t dimension = 0, tag = 0;
    std::string name;         ///< empty when it has none
    std::vector<Index> cells; ///< dimension 3
    std::vector<Quad> quads;  ///< dimension 2
    std::vector<Index> nodes; ///< dimension 0 and 1
};

/// What a Gmsh file holds: hexahedra in ascending order of their tags, and its groups.
struct ImportedMesh {
    Hexahedra hexahedra;
    std::vector<std::int64_t> cellTags;
    std::vector<PhysicalGroup> groups;
    std::vector<std::string> warnings;
};

/// Reads a .msh (2.2, 4.1), or runs a .geo and meshes it where `allowGeo`, with gmsh in a child
/// process. `name` is for messages. Throws Error(mesh): empty, damaged, cut short, wrong counts,
/// without hexahedra, with solid elements of another type.
ImportedMesh importMesh(const std::filesystem::path& file, const std::string& name, bool allowGeo);

} // namespace fpm
