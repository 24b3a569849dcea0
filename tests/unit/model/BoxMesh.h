#pragma once

#include "support/boxMesh.h"

#include <algorithm>

namespace fpm::test {

struct Box {
    std::string name;
    Point origin, size;
    std::array<Index, 3> cells{1, 1, 1};
};

/// Adds a box of hexahedra as a part of its own, with side sets <name>.xMin ... <name>.zMax.
inline void addBox(Mesh& mesh, const Box& box)
{
    Index element = Index(mesh.hexahedra.size());
    const Index firstElement = element;
    addBox(mesh, box.name, box.cells, box.origin, box.size);
    const auto& [nx, ny, nz] = box.cells;
    const auto addSide = [&](const char* set, bool onSide, Index side) {
        if (onSide) mesh.sideSets[box.name + set].push_back({element, side});
    };
    for (Index k = 0; k < nz; ++k)
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i, ++element) {
                addSide(".xMin", i == 0, 0);
                addSide(".xMax", i == nx - 1, 1);
                addSide(".yMin", j == 0, 2);
                addSide(".yMax", j == ny - 1, 3);
                addSide(".zMin", k == 0, 4);
                addSide(".zMax", k == nz - 1, 5);
            }
    if (mesh.patchStarts.empty()) mesh.patchStarts.push_back(0);
    for (Index start = firstElement; start < Index(mesh.hexahedra.size()); start += 256)
        mesh.patchStarts.push_back(std::min(start + 256, Index(mesh.hexahedra.size())));
}

inline Mesh boxMesh(const std::vector<Box>& boxes)
{
    Mesh mesh;
    for (const Box& box : boxes) addBox(mesh, box);
    return mesh;
}

/// The bodies of the annotated dictionaries: a rod over two plates, a sleeve and a die apart.
inline Mesh rodAndPlates()
{
    Mesh mesh = boxMesh({{"rod", {0, 0, 5}, {10, 10, 20}, {2, 2, 4}},
                         {"plate1", {0, 0, 4}, {20, 20, 1}, {4, 4, 1}},
                         {"plate2", {0, 0, 3}, {20, 20, 1}, {4, 4, 1}},
                         {"sleeve", {60, 0, 0}, {5, 5, 5}},
                         {"die", {0, 0, 40}, {20, 20, 2}, {2, 2, 1}}});
    mesh.sideSets["plateEdges"] = mesh.sideSets["plate1.xMax"];
    return mesh;
}

} // namespace fpm::test
