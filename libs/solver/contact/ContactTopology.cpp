#include "kernels/contact/broad/CellLists.h"
#include "mesh/Vector.h"
#include "solver/SetUp.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fpm {

namespace {

double lengthOf(const std::vector<Point>& points, Index a, Index b)
{
    return vector::length(vector::difference(points[std::size_t(b)], points[std::size_t(a)]));
}

/// Face and edge across each edge; none where the surface ends, or where more than two faces meet.
void addNeighbours(ContactPassSetup& out, const std::vector<Point>& points)
{
    std::map<std::pair<Index, Index>, std::vector<std::size_t>> edges;
    const auto ends = [&](std::size_t edge) -> std::pair<Index, Index> {
        const std::size_t next = edge / 4 * 4 + (edge + 1) % 4;
        return std::minmax(out.faceNode[edge], out.faceNode[next]); // copied, not referred to
    };
    for (std::size_t edge = 0; edge < out.faceNode.size(); ++edge)
        edges[ends(edge)].push_back(edge);
    out.neighbour.assign(out.faceNode.size(), freeEdge);
    for (const auto& [nodes, both] : edges) {
        const bool collapsed = lengthOf(points, nodes.first, nodes.second) == 0;
        for (const std::size_t edge : both)
            if (collapsed)
                out.neighbour[edge] = noEdge;
            else if (both.size() == 2)
                out.neighbour[edge] = Index(both[0] == edge ? both[1] : both[0]);
    }
}

/// Target nodes, and the rings of face corners around them.
void addTargetNodes(ContactPassSetup& out)
{
    out.target = out.faceNode;
    std::sort(out.target.begin(), out.target.end());
    out.target.erase(std::unique(out.target.begin(), out.target.end()), out.target.end());
    std::vector<Index> last(out.target.size(), -1);
    out.targetCorner.resize(out.target.size());
    out.nextAround.resize(out.faceNode.size());
    for (std::size_t i = 0; i < out.faceNode.size(); ++i) {
        const auto at = std::lower_bound(out.target.begin(), out.target.end(), out.faceNode[i]);
        const std::size_t node = std::size_t(at - out.target.begin());
        if (last[node] < 0)
            out.targetCorner[node] = Index(i);
        else
            out.nextAround[std::size_t(last[node])] = Index(i);
        out.nextAround[i] = out.targetCorner[node];
        last[node] = Index(i);
    }
}

/// Largest distance between two corners of a face.
double diagonalOf(const ContactPassSetup& pass, const std::vector<Point>& points, std::size_t face)
{
    double diagonal = 0;
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b)
            diagonal = std::max(diagonal, lengthOf(points, pass.faceNode[4 * face + a],
                                                   pass.faceNode[4 * face + b]));
    return diagonal;
}

} // namespace

void addTopology(ContactPassSetup& pass, const std::vector<Point>& points)
{
    addNeighbours(pass, points);
    addTargetNodes(pass);
    pass.reach = 0.25 * pass.meanFaceSize;
    double longest = 0, narrowest = 1e300, widest = 0;
    for (std::size_t face = 0; face < pass.faceThickness.size(); ++face) {
        const double diagonal = diagonalOf(pass, points, face),
                     margin = std::max(pass.reach, 0.5 * (pass.faceThickness[face] + pass.reach));
        longest = std::max(longest, diagonal);
        // However a face turns, its box is no larger than its diagonal; it may stretch by a fifth.
        narrowest = std::min(narrowest, 1.2 * diagonal + 2 * margin);
        widest = std::max(widest, 1.2 * diagonal + 2 * margin);
    }
    if (pass.search == ContactSearch::closestParticle) {
        pass.cellSize = std::max(pass.meanFaceSize, longest / std::sqrt(3.0) + pass.reach);
        return;
    }
    pass.cellSize = 0.5 * narrowest;
    pass.levels =
        std::min(CellLists::mostLevels, 1 + Index(std::ceil(std::log2(widest / narrowest))));
}

} // namespace fpm
