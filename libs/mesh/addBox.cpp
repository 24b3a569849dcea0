#include "mesh/addBox.h"

namespace fpm {

void addBox(
    Mesh& mesh, const std::string& name, std::array<Index, 3> cells, Point origin, Point size)
{
    const Index firstNode = Index(mesh.points.size());
    const auto firstElement = Index(mesh.hexahedra.size());
    const auto [nx, ny, nz] = cells;
    for (Index k = 0; k <= nz; ++k)
        for (Index j = 0; j <= ny; ++j)
            for (Index i = 0; i <= nx; ++i)
                mesh.points.push_back({origin[0] + size[0] * i / nx, origin[1] + size[1] * j / ny,
                                       origin[2] + size[2] * k / nz});
    const auto node = [&, nx = nx, ny = ny](Index i, Index j, Index k) {
        return firstNode + i + (nx + 1) * (j + (ny + 1) * k);
    };
    for (Index k = 0; k < nz; ++k)
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i)
                mesh.hexahedra.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                                          node(i, j + 1, k), node(i, j, k + 1),
                                          node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                          node(i, j + 1, k + 1)});
    mesh.parts.push_back({name, firstElement, nx * ny * nz});
}

} // namespace fpm
