#include "base/ElementShape.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

using namespace fpm;

namespace {

/// Every edge is walked once in each direction: the faces close the element and agree on which side
/// is outside; every node lies on some face.
template <class Shape>
void expectClosed()
{
    std::set<std::pair<int, int>> edges;
    std::set<int> nodes;
    for (const ElementFace& face : Shape::face) {
        ASSERT_TRUE(face.corners == 3 || face.corners == 4);
        for (int k = 0; k < face.corners; ++k) {
            const int from = face.node[k], to = face.node[(k + 1) % face.corners];
            EXPECT_TRUE(edges.insert({from, to}).second) << from << " to " << to;
            nodes.insert(from);
        }
    }
    for (const auto& [from, to] : edges) EXPECT_TRUE(edges.count({to, from})) << from << ' ' << to;
    EXPECT_EQ(int(nodes.size()), Shape::nodes);
}

} // namespace

TEST(ElementShape, FacesOfTheHexahedronCloseIt)
{
    expectClosed<HexahedronShape>();
    // Outside of the bottom ring 0 1 2 3 is below: its face runs the other way round.
    EXPECT_EQ(HexahedronShape::face[4].node[1], 3);
}
