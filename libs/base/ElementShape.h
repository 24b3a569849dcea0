#pragma once

namespace fpm {

/// A face of an element: its corners, counter-clockwise seen from outside. Triangles leave the last
/// place empty.
struct ElementFace {
    int corners; ///< 3 or 4
    int node[4]; ///< numbers inside the element
};

/// Shape of an element: a type with `nodes`, `faces` and `face[faces]`. Nodes and faces of the
/// hexahedron are numbered as in VTK: bottom ring, top ring; -xi, +xi, -eta, +eta, -zeta, +zeta.
struct HexahedronShape {
    static constexpr int nodes = 8, faces = 6;
    static constexpr ElementFace face[faces] = {{4, {0, 4, 7, 3}}, {4, {1, 2, 6, 5}},
                                                {4, {0, 1, 5, 4}}, {4, {3, 7, 6, 2}},
                                                {4, {0, 3, 2, 1}}, {4, {4, 5, 6, 7}}};
};

} // namespace fpm
