#pragma once

#include "mesh/Mesh.h"

#include <string>

namespace fpm {

/// Adds a part of nx x ny x nz bricks with nodes of its own, x fastest. Patches are left to
/// renumber().
void addBox(Mesh& mesh,
            const std::string& name,
            std::array<Index, 3> cells,
            Point origin = {0, 0, 0},
            Point size = {1, 1, 1});

} // namespace fpm
