#include "mesh/Patches.h"

#include "base/Error.h"
#include "mesh/MeshFile.h"
#include "mesh/Surface.h"
#include "support/boxMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

using namespace fpm;

namespace {

Mesh plates()
{
    Mesh mesh;
    test::addBox(mesh, "layer1", {50, 50, 1}, {0, 0, 0}, {100, 100, 1.7});
    test::addBox(mesh, "block", {13, 11, 9}, {0, 0, 1.7}, {13, 11, 9});
    mesh.sideSets["skin"] = skin(mesh, 1);
    mesh.nodeSets["nodes"] = nodesOf(mesh, mesh.sideSets["skin"]);
    return mesh;
}

/// Elements as the places of their corners: what renumbering must not change.
std::multiset<std::array<Point, 8>> shapes(const Mesh& mesh)
{
    std::multiset<std::array<Point, 8>> result;
    for (const auto& hexahedron : mesh.hexahedra) {
        std::array<Point, 8> x;
        for (std::size_t k = 0; k < 8; ++k) x[k] = mesh.points[std::size_t(hexahedron[k])];
        result.insert(x);
    }
    return result;
}

std::multiset<Point> centres(const Mesh& mesh, const std::vector<ElementSide>& sides)
{
    std::multiset<Point> result;
    for (const auto& side : sides) result.insert(centre(mesh, side));
    return result;
}

} // namespace

TEST(Renumber, KeepsTheMesh)
{
    const Mesh before = plates();
    Mesh after = before;

    const auto newNode = renumber(after);

    EXPECT_EQ(shapes(after), shapes(before));
    EXPECT_EQ(after.points.size(), before.points.size());
    for (std::size_t node = 0; node < newNode.size(); ++node)
        EXPECT_EQ(after.points[std::size_t(newNode[node])], before.points[node]);
    EXPECT_EQ(after.parts[1].firstElement, 2500);
    EXPECT_EQ(after.sideSets["skin"], skin(after, 1));
    EXPECT_EQ(centres(after, after.sideSets["skin"]), centres(before, skin(before, 1)));
    EXPECT_EQ(after.nodeSets["nodes"], nodesOf(after, after.sideSets["skin"]));
}

TEST(Renumber, MakesFullPatchesOfOnePart)
{
    Mesh mesh = plates();

    renumber(mesh);

    const auto& starts = mesh.patchStarts;
    EXPECT_EQ(starts.size() - 1, 10U + 6U);
    Index ragged = 0;
    for (std::size_t patch = 0; patch + 1 < starts.size(); ++patch) {
        const Index count = starts[patch + 1] - starts[patch];
        EXPECT_GT(count, 0);
        EXPECT_LE(count, 256);
        EXPECT_EQ(mesh.partOf(starts[patch]), mesh.partOf(starts[patch + 1] - 1));
        ragged += count % 16 != 0;
    }
    EXPECT_EQ(ragged, 2) << "2500 and 1287 are no multiples of 16: one patch each";
}

TEST(Renumber, MakesCompactPatches)
{
    Mesh plate = test::boxMesh({64, 64, 1}, {64, 64, 0.1}), block = test::boxMesh({24, 24, 24});

    renumber(plate);
    renumber(block);

    // 16 x 16 squares share 17 x 17 x 2 nodes at most 2 x 64 of which lie on the rim; bricks of
    // 6 x 6 x 7 have 392 nodes.
    const Patches squares = makePatches(plate), bricks = makePatches(block);
    for (const auto& patch : squares.patches) EXPECT_EQ(patch.nodeCount, 17 * 17 * 2);
    double nodes = 0;
    for (const auto& patch : bricks.patches) nodes += patch.nodeCount;
    EXPECT_LT(nodes / double(bricks.patches.size()), 420);
}

TEST(Renumber, PutsInteriorNodesFirst)
{
    Mesh mesh = plates();
    renumber(mesh);

    const Patches patches = makePatches(mesh);

    Index next = 0;
    for (const auto& patch : patches.patches)
        for (Index slot = 0; slot < patch.interiorCount; ++slot)
            EXPECT_EQ(patches.slotNode[std::size_t(patch.firstSlot + slot)], next++);
    for (const auto& patch : patches.patches)
        for (Index slot = patch.interiorCount; slot < patch.nodeCount; ++slot)
            EXPECT_GE(patches.slotNode[std::size_t(patch.firstSlot + slot)], next);
}

TEST(Renumber, DoesNotDependOnTheOrderOfEqualElements)
{
    Mesh mesh = plates(), again = plates();

    renumber(mesh);
    renumber(again);
    EXPECT_EQ(meshChecksum(mesh), meshChecksum(again));

    // Numbering a numbered mesh changes nothing about its patches.
    renumber(again);
    EXPECT_EQ(again.patchStarts, mesh.patchStarts);
    EXPECT_EQ(again.hexahedra, mesh.hexahedra);
}

TEST(Renumber, KeepsRowsTogetherInSpiteOfRounding)
{
    Mesh exact = test::boxMesh({50, 50, 1}), noisy = exact;
    std::mt19937 random(3);
    for (auto& point : noisy.points)
        for (double& x : point) x += 1e-14 * (double(random()) / 4294967296.0 - 0.5);

    renumber(exact);
    renumber(noisy);

    EXPECT_EQ(exact.hexahedra, noisy.hexahedra);
}

TEST(Renumber, DropsNodesWithoutElement)
{
    Mesh mesh = test::boxMesh({2, 2, 2});
    mesh.points.insert(mesh.points.begin(), Point{5, 5, 5});
    for (auto& hexahedron : mesh.hexahedra)
        for (Index& node : hexahedron) ++node;
    mesh.nodeSets["some"] = {0, 3};
    mesh.contactKey = "old";

    const auto newNode = renumber(mesh);

    EXPECT_EQ(mesh.points.size(), 27U);
    EXPECT_EQ(newNode[0], -1);
    EXPECT_EQ(mesh.nodeSets["some"], (std::vector<Index>{newNode[3]}));
    EXPECT_EQ(mesh.contactKey, "");
}

TEST(Renumber, SurvivesElementsAtOnePlace)
{
    Mesh mesh = test::boxMesh({1, 1, 1});
    mesh.hexahedra.assign(1000, mesh.hexahedra.front());
    mesh.parts = {{"heap", 0, 1000}};

    renumber(mesh);

    EXPECT_EQ(mesh.patchStarts.back(), 1000);
    EXPECT_EQ(mesh.patchStarts.size(), 5U);
}

TEST(Patches, CornersLeadBackToTheNodes)
{
    Mesh mesh = plates();
    renumber(mesh);

    const Patches patches = makePatches(mesh);

    for (const auto& patch : patches.patches) {
        EXPECT_LE(patch.nodeCount, 2048);
        for (Index element = patch.firstElement; element < patch.firstElement + patch.elementCount;
             ++element)
            for (std::size_t k = 0; k < 8; ++k) {
                const Index local = patches.corners[8 * std::size_t(element) + k];
                ASSERT_LT(local, patch.nodeCount);
                EXPECT_EQ(patches.slotNode[std::size_t(patch.firstSlot + local)],
                          mesh.hexahedra[std::size_t(element)][k]);
            }
    }
}

TEST(Patches, SlotsListTheirCornersInAscendingOrder)
{
    Mesh mesh = plates();
    renumber(mesh);

    const Patches patches = makePatches(mesh);

    EXPECT_EQ(patches.slotCorners.size(), 8 * mesh.hexahedra.size());
    EXPECT_EQ(patches.slotCornerStart.size(), patches.slotNode.size() + 1);
    EXPECT_EQ(patches.slotCornerStart.back(), Index(patches.slotCorners.size()));
    for (const auto& patch : patches.patches)
        for (Index local = 0; local < patch.nodeCount; ++local) {
            const auto slot = std::size_t(patch.firstSlot + local);
            int previous = -1;
            EXPECT_LT(patches.slotCornerStart[slot], patches.slotCornerStart[slot + 1]);
            for (Index k = patches.slotCornerStart[slot]; k < patches.slotCornerStart[slot + 1];
                 ++k) {
                const int entry = patches.slotCorners[std::size_t(k)];
                EXPECT_GT(entry, previous);
                previous = entry;
                EXPECT_EQ(patches.corners[8 * std::size_t(patch.firstElement) + std::size_t(entry)],
                          local);
            }
        }
}

TEST(Patches, NodesKnowTheirSlotsInAscendingOrder)
{
    Mesh mesh = plates();
    renumber(mesh);

    const Patches patches = makePatches(mesh);

    EXPECT_EQ(patches.nodeSlotStart.back(), Index(patches.slotNode.size()));
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
        Index previous = -1;
        EXPECT_LT(patches.nodeSlotStart[node], patches.nodeSlotStart[node + 1]);
        for (Index k = patches.nodeSlotStart[node]; k < patches.nodeSlotStart[node + 1]; ++k) {
            const Index slot = patches.nodeSlots[std::size_t(k)];
            EXPECT_GT(slot, previous);
            previous = slot;
            EXPECT_EQ(patches.slotNode[std::size_t(slot)], Index(node));
        }
    }
}

TEST(Patches, InteriorNodesHaveOneSlot)
{
    Mesh mesh = plates();
    renumber(mesh);

    const Patches patches = makePatches(mesh);

    for (const auto& patch : patches.patches)
        for (Index local = 0; local < patch.nodeCount; ++local) {
            const auto node = std::size_t(patches.slotNode[std::size_t(patch.firstSlot + local)]);
            const Index slots = patches.nodeSlotStart[node + 1] - patches.nodeSlotStart[node];
            EXPECT_EQ(slots == 1, local < patch.interiorCount);
        }
}

TEST(Patches, RefusesAMeshThatIsNotDivided)
{
    Mesh mesh = test::boxMesh({10, 10, 10});

    EXPECT_THROW(makePatches(mesh), Error);
    mesh.patchStarts = {0, 1000};
    EXPECT_THROW(makePatches(mesh), Error) << "1000 elements do not fit a patch";
}
