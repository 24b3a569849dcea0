#pragma once

#include <array>
#include <vector>

namespace fpm {

/// The exact node places of discSection. In a quarter the core is the bilinear image of a square
/// with corners (0, 0), (coreEdge, 0), (coreDiagonal, coreDiagonal), (0, coreEdge); from each node
/// of its outer sides `rings` equal cells go straight to the arc, whose nodes stand at equal
/// angles.
class DiscNodes
{
public:
    struct Node {
        std::array<double, 2> place;
        bool onArc;
    };

    DiscNodes(int core, int rings);
    /// The node meant by (x, y), up to gmsh's error. Bit-symmetric about axes and diagonals. Throws
    /// Error(mesh) when there is none.
    Node nearest(double x, double y) const;

private:
    std::vector<Node> quarter_; ///< first quarter, ascending x

    void add(double x, double y, bool onArc);
};

} // namespace fpm
