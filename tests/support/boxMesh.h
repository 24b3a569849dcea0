#pragma once

#include "mesh/addBox.h"

namespace fpm::test {

using fpm::addBox;

/// One part of nx x ny x nz bricks.
inline Mesh boxMesh(std::array<Index, 3> cells, Point size = {1, 1, 1})
{
    Mesh mesh;
    addBox(mesh, "box", cells, {0, 0, 0}, size);
    return mesh;
}

} // namespace fpm::test
