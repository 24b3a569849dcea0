#pragma once

#include "base/Log.h"
#include "mesh/Mesh.h"
#include "mesher/Section.h"
#include "mesher/TagMap.h"

#include <functional>
#include <string>
#include <vector>

namespace fpm {

/// Nodes and hexahedra as gmsh made them, numbered from 0 in ascending order of their tags.
struct Hexahedra {
    std::vector<Point> points;
    std::vector<Hexahedron> cells;
};

/// Runs `work` inside a gmsh of its own (no configuration files, one thread, silent). gmsh keeps
/// its state after an error, so none outlives a body. Returns its warnings; whatever it throws
/// becomes Error(mesh): "<subject>: gmsh stopped: <its words>".
std::vector<std::string> withGmsh(const std::string& subject, const std::function<void()>& work);

/// Nodes and hexahedra of the current gmsh model. `foreign` counts its solid elements of any other
/// type: "12 x Tetrahedron 4"; empty when there are none. `tags` are those of the hexahedra.
Hexahedra fetchHexahedra(TagMap& nodes, TagMap& tags, std::string& foreign);

/// Meshes the blocks of `section` with quadrilaterals and extrudes them from z = 0 to z = 1 in
/// `layers` equal layers. Throws Error(mesh) when gmsh does not give `expectedCells` hexahedra.
Hexahedra extrude(const std::string& subject,
                  const Section& section,
                  int layers,
                  std::int64_t expectedCells,
                  Log& log);

} // namespace fpm
