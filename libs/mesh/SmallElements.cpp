#include "mesh/SmallElements.h"

#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "mesh/Vector.h"
#include "mesh/scaledJacobian.h"

#include <algorithm>
#include <set>

namespace fpm {

namespace {

constexpr double fewAtMost = 0.1, ratioAtLeast = 3;

Point middleOf(const Mesh& mesh, Index element)
{
    Point sum{0, 0, 0};
    for (const Point& corner : corners(mesh, element)) sum = vector::sum(sum, corner);
    return vector::scaled(sum, 1.0 / 8);
}

std::string placeText(const Point& p)
{
    return format("({} {} {})", toText(p[0], 4), toText(p[1], 4), toText(p[2], 4));
}

} // namespace

std::optional<SmallElements> smallElements(const Mesh& mesh, const std::vector<double>& sizes)
{
    std::vector<double> sorted;
    for (const double size : sizes)
        if (size > 0) sorted.push_back(size);
    if (sorted.empty()) return std::nullopt;
    std::sort(sorted.begin(), sorted.end());
    SmallElements few;
    few.total = sorted.size();
    few.least = sorted.front();
    few.ordinary = sorted[sorted.size() / 2];
    const double bound = 2 * few.least;
    few.count = std::size_t(std::upper_bound(sorted.begin(), sorted.end(), bound) - sorted.begin());
    if (few.ratio() < ratioAtLeast || double(few.count) > fewAtMost * double(few.total))
        return std::nullopt;
    few.lower = {1e300, 1e300, 1e300};
    few.upper = {-1e300, -1e300, -1e300};
    std::set<Index> parts;
    for (std::size_t element = 0; element < sizes.size(); ++element) {
        if (!(sizes[element] > 0) || sizes[element] > bound) continue;
        parts.insert(mesh.partOf(Index(element)));
        const Point middle = middleOf(mesh, Index(element));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            few.lower[axis] = std::min(few.lower[axis], middle[axis]);
            few.upper[axis] = std::max(few.upper[axis], middle[axis]);
        }
    }
    for (const Index part : parts) few.parts.push_back(mesh.parts[std::size_t(part)].name);
    return few;
}

std::string smallElementsText(const SmallElements& few)
{
    std::string names;
    for (const std::string& name : few.parts) names += (names.empty() ? "" : ", ") + name;
    return format("{} of {} elements ({} {}, between {} and {})", few.count, few.total,
                  few.parts.size() == 1 ? "part" : "parts", names, placeText(few.lower),
                  placeText(few.upper));
}

std::vector<double> elementHeights(const Mesh& mesh)
{
    std::vector<double> heights;
    for (Index element = 0; element < Index(mesh.hexahedra.size()); ++element) {
        double largest = 0;
        for (Index side = 0; side < 6; ++side)
            largest = std::max(largest, area(mesh, {element, side}));
        heights.push_back(largest > 0 ? volume(mesh, element) / largest : 0);
    }
    return heights;
}

} // namespace fpm
