#pragma once

#include <array>
#include <vector>

namespace fpm {

/// A plane figure cut into four-sided blocks, at unit size: what gmsh meshes and extrudes. Arcs
/// have their centre in the origin and span less than half a turn.
struct Section {
    struct Curve {
        int from, to; ///< points
        int cells;    ///< equal cells along it
        bool arc;
    };
    /// Four curves counter-clockwise: number + 1, negative where the block runs against the curve.
    using Block = std::array<int, 4>;

    std::vector<std::array<double, 2>> points;
    std::vector<Curve> curves;
    std::vector<Block> blocks;

    /// Number of the added point.
    int addPoint(std::array<double, 2> point);
    /// The added curve as a block names it (its number + 1).
    int addCurve(int from, int to, int cells, bool arc = false);
};

/// Inner block of the O-grid, in radii: its corners lie on the axes at `coreEdge` and on the
/// diagonal at (coreDiagonal, coreDiagonal).
inline constexpr double coreEdge = 0.55, coreDiagonal = 0.42;

/// Unit square from the origin.
Section squareSection(int cellsX, int cellsY);
/// O-grid of the unit circle: in each quarter core x core cells and `rings` cells out to the arc.
Section discSection(int core, int rings, int quarters);
/// Ring of radii 1 and 2 over `quarters` (1, 2, 4) with equal cells, from the x axis on.
Section ringSection(int circumferential, int radial, int quarters);

/// Cosine and sine of the angle `step` / `steps` of `quarters` quarter turns. Exact on the axes and
/// symmetric to the bit about axes and diagonals.
std::array<double, 2> direction(int step, int steps, int quarters);
/// (x, y) turned by `quarters` quarter turns, exactly.
std::array<double, 2> turned(std::array<double, 2> point, int quarters);

} // namespace fpm
