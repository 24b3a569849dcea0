#include "mesher/DiscNodes.h"

#include "base/Error.h"
#include "base/Format.h"
#include "mesher/Section.h"

#include <algorithm>
#include <cmath>

namespace fpm {

DiscNodes::DiscNodes(int core, int rings)
{
    const auto corePlace = [&](int i, int j) -> std::array<double, 2> {
        const double u = double(i) / core, v = double(j) / core;
        const double bend = u * v * (coreEdge - coreDiagonal);
        return {u * coreEdge - bend, v * coreEdge - bend};
    };
    for (int i = 0; i <= core; ++i)
        for (int j = 0; j <= core; ++j) add(corePlace(i, j)[0], corePlace(i, j)[1], false);
    for (int j = 0; j <= core; ++j) {
        const auto edge = corePlace(core, j);
        const auto arc = direction(j, 2 * core, 1);
        for (int ring = 1; ring <= rings; ++ring) {
            const double w = double(ring) / rings;
            const double x = (1 - w) * edge[0] + w * arc[0], y = (1 - w) * edge[1] + w * arc[1];
            add(x, y, ring == rings);
            if (j < core) add(y, x, ring == rings); // the mirror image about the diagonal
        }
    }
    std::sort(quarter_.begin(), quarter_.end(),
              [](const Node& a, const Node& b) { return a.place < b.place; });
}

void DiscNodes::add(double x, double y, bool onArc)
{
    quarter_.push_back({{x, y}, onArc});
}

DiscNodes::Node DiscNodes::nearest(double x, double y) const
{
    constexpr double tolerance = 1e-6; // of the radius; gmsh's own error is below 1e-8
    int turns = 0;
    std::array<double, 2> folded{x, y};
    while (folded[0] < -tolerance || folded[1] < -tolerance) {
        folded = turned(folded, 3);
        ++turns;
    }
    auto node = std::lower_bound(quarter_.begin(), quarter_.end(), folded[0] - tolerance,
                                 [](const Node& a, double low) { return a.place[0] < low; });
    for (; node != quarter_.end() && node->place[0] <= folded[0] + tolerance; ++node)
        if (std::abs(node->place[1] - folded[1]) <= tolerance)
            return {turned(node->place, turns), node->onArc};
    throw Error(ExitCode::mesh, format("gmsh put a node at ({} {}) of the unit disc, where none "
                                       "should be",
                                       x, y));
}

} // namespace fpm
