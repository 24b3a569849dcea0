#include "mesh/Mesh.h"

#include <algorithm>

namespace fpm {

Index Mesh::partOf(Index element) const
{
    const auto next = std::ranges::upper_bound(parts, element, {}, &MeshPart::firstElement);
    return Index(next - parts.begin()) - 1;
}

Index Mesh::findPart(const std::string& name) const
{
    const auto found = std::ranges::find(parts, name, &MeshPart::name);
    return found == parts.end() ? -1 : Index(found - parts.begin());
}

Quad Mesh::sideNodes(const ElementSide& side) const
{
    const Hexahedron& nodes = hexahedra[std::size_t(side.element)];
    Quad quad;
    for (std::size_t k = 0; k < 4; ++k)
        quad[k] = nodes[std::size_t(sideCorners[std::size_t(side.side)][k])];
    return quad;
}

} // namespace fpm
