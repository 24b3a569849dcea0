#include "mesh/Patches.h"
#include "mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fpm {
namespace {

/// Patches of a whole number of these fill every SIMD batch (at most 16 numbers wide).
constexpr Index batch = 16;

/// Element with the place of its centre in whole steps, so that rounding cannot shuffle a row of
/// elements that lie side by side.
struct Item {
    std::array<std::int32_t, 3> place;
    Index element;
};

Point low(const Mesh& mesh, Index element)
{
    Point lowest = mesh.points[std::size_t(mesh.hexahedra[std::size_t(element)][0])];
    for (const Index node : mesh.hexahedra[std::size_t(element)])
        for (std::size_t k = 0; k < 3; ++k)
            lowest[k] = std::min(lowest[k], mesh.points[std::size_t(node)][k]);
    return lowest;
}

Point high(const Mesh& mesh, Index element)
{
    Point highest = mesh.points[std::size_t(mesh.hexahedra[std::size_t(element)][0])];
    for (const Index node : mesh.hexahedra[std::size_t(element)])
        for (std::size_t k = 0; k < 3; ++k)
            highest[k] = std::max(highest[k], mesh.points[std::size_t(node)][k]);
    return highest;
}

/// Centres of the part's elements, each direction in units of the mean element size there: patches
/// shall be compact in numbers of elements, for what they share are nodes.
std::vector<Item> placeElements(const Mesh& mesh, const MeshPart& part)
{
    constexpr double stepsPerElement = 1024;
    constexpr double maxSteps = 1 << 30;
    const auto count = std::size_t(part.elementCount);
    std::vector<Point> centres(count);
    Point size{}, lowest, highest{};
    lowest.fill(std::numeric_limits<double>::max());
    highest.fill(std::numeric_limits<double>::lowest());
    for (std::size_t k = 0; k < count; ++k) {
        const Point from = low(mesh, part.firstElement + Index(k));
        const Point to = high(mesh, part.firstElement + Index(k));
        centres[k] = vector::scaled(vector::sum(from, to), 0.5);
        size = vector::sum(size, vector::difference(to, from));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = std::min(lowest[axis], centres[k][axis]);
            highest[axis] = std::max(highest[axis], centres[k][axis]);
        }
    }
    std::vector<Item> items(count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double range = highest[axis] - lowest[axis];
        const double steps = size[axis] > 0 ? stepsPerElement * double(count) / size[axis] : 0;
        const double scale = range > 0 ? std::min(steps, maxSteps / range) : 0;
        for (std::size_t k = 0; k < count; ++k)
            items[k].place[axis] =
                std::int32_t(std::lround((centres[k][axis] - lowest[axis]) * scale));
    }
    for (std::size_t k = 0; k < count; ++k) items[k].element = part.firstElement + Index(k);
    return items;
}

/// Axes by extent of the items' box, longest first.
std::array<std::size_t, 3> longestAxes(std::span<const Item> items)
{
    std::array<std::int32_t, 3> lowest = items.front().place, highest = lowest;
    for (const auto& item : items)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = std::min(lowest[axis], item.place[axis]);
            highest[axis] = std::max(highest[axis], item.place[axis]);
        }
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::ranges::stable_sort(axes, std::greater(),
                             [&](std::size_t axis) { return highest[axis] - lowest[axis]; });
    return axes;
}

/// Total order: by place along the axes in turn, at last by element number.
auto byPlace(std::array<std::size_t, 3> axes)
{
    return [axes](const Item& a, const Item& b) {
        for (const std::size_t axis : axes)
            if (a.place[axis] != b.place[axis]) return a.place[axis] < b.place[axis];
        return a.element < b.element;
    };
}

/// Elements of the first half when `count` elements are to become `patches` patches.
Index splitAt(Index count, Index patches, Index maxCount)
{
    const Index half = patches / 2;
    const auto even = Index(std::int64_t(count) * half / patches);
    const Index rounded = (even + batch / 2) / batch * batch;
    const Index least = count - maxCount * (patches - half), most = maxCount * half;
    return rounded >= std::max<Index>(least, 1) && rounded <= std::min(most, count - 1) ? rounded
                                                                                        : even;
}

/// Orders the items patch by patch and appends the patches' sizes. Depth is log2(patches).
void bisect(std::span<Item> items, Index patches, Index maxCount, std::vector<Index>& sizes)
{
    const auto axes = longestAxes(items);
    if (patches == 1) {
        // Neighbours along the longest axis follow one another and share a side.
        std::ranges::sort(items, byPlace({axes[2], axes[1], axes[0]}));
        sizes.push_back(Index(items.size()));
        return;
    }
    const Index first = splitAt(Index(items.size()), patches, maxCount);
    std::ranges::nth_element(items, items.begin() + first, byPlace(axes));
    bisect(items.first(std::size_t(first)), patches / 2, maxCount, sizes);
    bisect(items.subspan(std::size_t(first)), patches - patches / 2, maxCount, sizes);
}

/// Old element at each new place; sets patchStarts.
std::vector<Index> orderElements(Mesh& mesh, Index maxCount)
{
    std::vector<Index> oldElement;
    oldElement.reserve(mesh.hexahedra.size());
    mesh.patchStarts.assign(1, 0);
    for (const auto& part : mesh.parts) {
        if (part.elementCount == 0) continue;
        std::vector<Item> items = placeElements(mesh, part);
        std::vector<Index> sizes;
        bisect(items, (part.elementCount + maxCount - 1) / maxCount, maxCount, sizes);
        for (const auto& item : items) oldElement.push_back(item.element);
        for (const Index size : sizes) mesh.patchStarts.push_back(mesh.patchStarts.back() + size);
    }
    return oldElement;
}

/// New number of each old node (-1: none): interior nodes in order of first use, then the others.
std::vector<Index> orderNodes(const Mesh& mesh, std::size_t& nodeCount)
{
    constexpr Index none = -1, shared = -2;
    std::vector<Index> owner(mesh.points.size(), none), number(mesh.points.size(), none);
    for (std::size_t patch = 0; patch + 1 < mesh.patchStarts.size(); ++patch)
        for (Index element = mesh.patchStarts[patch]; element < mesh.patchStarts[patch + 1];
             ++element)
            for (const Index node : mesh.hexahedra[std::size_t(element)]) {
                Index& mine = owner[std::size_t(node)];
                mine = mine == none || mine == Index(patch) ? Index(patch) : shared;
            }
    Index next = 0;
    for (const bool wantsShared : {false, true})
        for (const auto& hexahedron : mesh.hexahedra)
            for (const Index node : hexahedron)
                if (number[std::size_t(node)] == none
                    && (owner[std::size_t(node)] == shared) == wantsShared)
                    number[std::size_t(node)] = next++;
    nodeCount = std::size_t(next);
    return number;
}

void renumberSets(Mesh& mesh,
                  const std::vector<Index>& newNode,
                  const std::vector<Index>& newElement)
{
    for (auto& [name, nodes] : mesh.nodeSets) {
        for (Index& node : nodes) node = newNode[std::size_t(node)];
        std::erase(nodes, -1);
        std::ranges::sort(nodes);
    }
    for (auto& [name, sides] : mesh.sideSets) {
        for (auto& side : sides) side.element = newElement[std::size_t(side.element)];
        std::ranges::sort(sides);
    }
    mesh.contact.clear();
    mesh.contactKey.clear();
}

} // namespace

std::vector<Index> renumber(Mesh& mesh, Index maxCount)
{
    const std::vector<Index> oldElement = orderElements(mesh, maxCount);
    std::vector<Hexahedron> hexahedra(oldElement.size());
    std::vector<Index> newElement(mesh.hexahedra.size());
    for (std::size_t element = 0; element < oldElement.size(); ++element) {
        hexahedra[element] = mesh.hexahedra[std::size_t(oldElement[element])];
        newElement[std::size_t(oldElement[element])] = Index(element);
    }
    mesh.hexahedra = std::move(hexahedra);

    std::size_t nodeCount = 0;
    const std::vector<Index> newNode = orderNodes(mesh, nodeCount);
    std::vector<Point> points(nodeCount);
    for (std::size_t node = 0; node < newNode.size(); ++node)
        if (newNode[node] >= 0) points[std::size_t(newNode[node])] = mesh.points[node];
    mesh.points = std::move(points);
    for (auto& hexahedron : mesh.hexahedra)
        for (Index& node : hexahedron) node = newNode[std::size_t(node)];
    renumberSets(mesh, newNode, newElement);
    return newNode;
}

} // namespace fpm
