#include "mesh/Patches.h"

#include "base/Error.h"
#include "base/Format.h"

#include <algorithm>

namespace fpm {
namespace {

constexpr Index cornerCount = 8;
constexpr Index unseen = -1;

void requirePatchStarts(const Mesh& mesh)
{
    const auto& starts = mesh.patchStarts;
    bool good =
        !starts.empty() && starts.front() == 0 && starts.back() == Index(mesh.hexahedra.size());
    for (std::size_t patch = 0; good && patch + 1 < starts.size(); ++patch) {
        const Index count = starts[patch + 1] - starts[patch];
        good = count > 0 && count <= maxPatchElements
               && mesh.partOf(starts[patch]) == mesh.partOf(starts[patch + 1] - 1);
    }
    if (!good)
        throw Error(ExitCode::internal,
                    "the mesh is not divided into patches of 1 to 256 elements of one part",
                    "renumber() does that");
}

/// Number of patches that have each node.
std::vector<Index> patchCounts(const Mesh& mesh)
{
    std::vector<Index> counts(mesh.points.size(), 0), lastPatch(mesh.points.size(), unseen);
    for (std::size_t patch = 0; patch + 1 < mesh.patchStarts.size(); ++patch)
        for (Index element = mesh.patchStarts[patch]; element < mesh.patchStarts[patch + 1];
             ++element)
            for (const Index node : mesh.hexahedra[std::size_t(element)]) {
                if (lastPatch[std::size_t(node)] == Index(patch)) continue;
                lastPatch[std::size_t(node)] = Index(patch);
                ++counts[std::size_t(node)];
            }
    return counts;
}

/// Appends the slots of one patch: interior nodes, then the others, each ascending, so that both
/// the patch's own run of node numbers and the shared nodes are read in the order of memory.
void addSlots(const Mesh& mesh,
              const std::vector<Index>& counts,
              std::vector<Index>& slotOfNode,
              Patch& patch,
              Patches& result)
{
    std::vector<Index> nodes;
    for (Index element = 0; element < patch.elementCount; ++element) {
        const auto& corners = mesh.hexahedra[std::size_t(patch.firstElement + element)];
        nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    const auto boundary = std::stable_partition(
        nodes.begin(), nodes.end(), [&](Index node) { return counts[std::size_t(node)] == 1; });
    patch.firstSlot = Index(result.slotNode.size());
    patch.nodeCount = Index(nodes.size());
    patch.interiorCount = Index(boundary - nodes.begin());
    for (Index slot = 0; slot < patch.nodeCount; ++slot)
        slotOfNode[std::size_t(nodes[std::size_t(slot)])] = slot;
    result.slotNode.insert(result.slotNode.end(), nodes.begin(), nodes.end());
}

/// The patch's corners as node numbers inside the patch, and the corners around each of its slots.
void addCorners(const Mesh& mesh,
                const std::vector<Index>& slotOfNode,
                const Patch& patch,
                Patches& result)
{
    std::vector<Index> next(std::size_t(patch.nodeCount) + 1, 0);
    const std::size_t first = result.corners.size();
    for (Index element = 0; element < patch.elementCount; ++element)
        for (const Index node : mesh.hexahedra[std::size_t(patch.firstElement + element)]) {
            const Index slot = slotOfNode[std::size_t(node)];
            result.corners.push_back(std::uint16_t(slot));
            ++next[std::size_t(slot) + 1];
        }
    const auto begin = Index(result.slotCorners.size());
    next[0] = begin;
    for (std::size_t slot = 1; slot < next.size(); ++slot) next[slot] += next[slot - 1];
    result.slotCornerStart.insert(result.slotCornerStart.end(), next.begin(), next.end() - 1);
    result.slotCorners.resize(result.corners.size());
    for (Index corner = 0; corner < cornerCount * patch.elementCount; ++corner) {
        const Index slot = result.corners[first + std::size_t(corner)];
        result.slotCorners[std::size_t(next[std::size_t(slot)]++)] = std::uint16_t(corner);
    }
}

/// Slots around each node, by counting sort: ascending slot, hence ascending patch.
void addNodeSlots(const std::vector<Index>& counts, Patches& result)
{
    result.nodeSlotStart.assign(counts.size() + 1, 0);
    for (std::size_t node = 0; node < counts.size(); ++node)
        result.nodeSlotStart[node + 1] = result.nodeSlotStart[node] + counts[node];
    result.nodeSlots.resize(result.slotNode.size());
    std::vector<Index> next(result.nodeSlotStart.begin(), result.nodeSlotStart.end() - 1);
    for (std::size_t slot = 0; slot < result.slotNode.size(); ++slot)
        result.nodeSlots[std::size_t(next[std::size_t(result.slotNode[slot])]++)] = Index(slot);
}

} // namespace

Patches makePatches(const Mesh& mesh)
{
    requirePatchStarts(mesh);
    // slotCornerStart counts 8 corners an element in 32 bits.
    if (mesh.hexahedra.size() > maxElements)
        throw Error(ExitCode::mesh,
                    format("{} elements; at most {} fit 32-bit numbers", mesh.hexahedra.size(),
                           maxElements),
                    "use a coarser mesh");
    Patches result;
    result.corners.reserve(std::size_t(cornerCount) * mesh.hexahedra.size());
    const std::vector<Index> counts = patchCounts(mesh);
    std::vector<Index> slotOfNode(mesh.points.size());
    for (std::size_t number = 0; number + 1 < mesh.patchStarts.size(); ++number) {
        Patch patch{};
        patch.firstElement = mesh.patchStarts[number];
        patch.elementCount = mesh.patchStarts[number + 1] - patch.firstElement;
        patch.part = mesh.partOf(patch.firstElement);
        addSlots(mesh, counts, slotOfNode, patch, result);
        addCorners(mesh, slotOfNode, patch, result);
        result.patches.push_back(patch);
    }
    result.slotCornerStart.push_back(Index(result.slotCorners.size()));
    addNodeSlots(counts, result);
    return result;
}

} // namespace fpm
