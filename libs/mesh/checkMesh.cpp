#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Vector.h"
#include "mesh/scaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace fpm {
namespace {

constexpr double maxCoordinate = 1e15;
constexpr double poorJacobian = 0.1;
constexpr double coincidence = 1e-9; ///< of the part's extent
constexpr std::size_t listed = 10;

/// "3 (4, 17, 20)"; of many the first ten.
std::string counted(const std::vector<Index>& numbers)
{
    std::string text = toText(numbers.size()) + " (";
    for (std::size_t k = 0; k < std::min(listed, numbers.size()); ++k)
        text += (k == 0 ? "" : ", ") + toText(numbers[k]);
    return text + (numbers.size() > listed ? ", ...)" : ")");
}

/// Element numbers that satisfy a condition.
template <class Condition>
std::vector<Index> elementsWhere(const Mesh& mesh, const Condition& condition)
{
    std::vector<Index> found;
    for (Index element = 0; element < Index(mesh.hexahedra.size()); ++element)
        if (condition(element)) found.push_back(element);
    return found;
}

void refuseIfAny(const std::vector<Index>& numbers,
                 const std::string& source,
                 const std::string& fault,
                 const std::string& advice)
{
    if (numbers.empty()) return;
    throw Error(ExitCode::mesh, format("{}: {}: {}", source, fault, counted(numbers)),
                advice + " (numbers count from 0)");
}

void checkNodes(const Mesh& mesh, const std::string& source)
{
    std::vector<Index> bad;
    for (Index node = 0; node < Index(mesh.points.size()); ++node) {
        const auto& point = mesh.points[std::size_t(node)];
        if (!std::ranges::all_of(point, [](double x) { return std::abs(x) <= maxCoordinate; }))
            bad.push_back(node);
    }
    refuseIfAny(bad, source, "nodes whose coordinates are no numbers or beyond 1e15",
                "check the geometry and its units");
}

void checkNumbers(const Mesh& mesh, const std::string& source)
{
    const auto outside = elementsWhere(mesh, [&](Index element) {
        return std::ranges::any_of(mesh.hexahedra[std::size_t(element)], [&](Index node) {
            return node < 0 || std::size_t(node) >= mesh.points.size();
        });
    });
    refuseIfAny(outside, source,
                format("elements that name nodes outside 0 ... {}", Index(mesh.points.size()) - 1),
                "the mesh is damaged; export it again");
    const auto repeating = elementsWhere(mesh, [&](Index element) {
        auto nodes = mesh.hexahedra[std::size_t(element)];
        std::ranges::sort(nodes);
        return std::ranges::adjacent_find(nodes) != nodes.end();
    });
    refuseIfAny(
        repeating, source, "elements that name a node twice",
        "wedges and pyramids written as hexahedra are not supported; mesh with hexahedra only");
}

void checkShapes(const Mesh& mesh, const std::string& source, Log& log)
{
    std::vector<Index> inverted, poor;
    for (Index element = 0; element < Index(mesh.hexahedra.size()); ++element) {
        const double jacobian = minScaledJacobian(corners(mesh, element));
        if (!(jacobian > 0) || !(volume(mesh, element) > 0))
            inverted.push_back(element);
        else if (jacobian < poorJacobian)
            poor.push_back(element);
    }
    const bool all = inverted.size() == mesh.hexahedra.size();
    refuseIfAny(inverted, source, "elements without volume or with a corner turned inside out",
                all ? "all of them: mirrored numbering; list the bottom ring of nodes "
                      "counter-clockwise seen from the top ring"
                    : "move their nodes or mesh this region again");
    if (!poor.empty())
        log.warning(format("{}: badly distorted elements (scaled Jacobian below {}): {}", source,
                           poorJacobian, counted(poor)));
}

/// Nodes that could go because another one lies at the same place. Groups are split wherever a gap
/// opens along one axis after the other; what no axis splits lies together.
std::size_t surplusNodes(const Mesh& mesh, std::span<Index> nodes, double gap)
{
    struct Group {
        std::span<Index> nodes;
        std::size_t axis;
        int unsplit; ///< axes that did not split it, in succession
    };
    std::vector<Group> open{{nodes, 0, 0}};
    std::size_t surplus = 0;
    while (!open.empty()) {
        const auto [members, axis, unsplit] = open.back();
        open.pop_back();
        if (unsplit == 3) surplus += members.size() - 1;
        if (unsplit == 3 || members.size() < 2) continue;
        const auto place = [&, axis = axis](Index node) {
            return mesh.points[std::size_t(node)][axis];
        };
        std::ranges::sort(members, {}, place);
        for (std::size_t begin = 0, end = 1; end <= members.size(); ++end) {
            if (end < members.size() && place(members[end]) - place(members[end - 1]) <= gap)
                continue;
            const bool whole = end - begin == members.size();
            open.push_back(
                {members.subspan(begin, end - begin), (axis + 1) % 3, whole ? unsplit + 1 : 0});
            begin = end;
        }
    }
    return surplus;
}

void checkCoincidentNodes(const Mesh& mesh, const std::string& source, Log& log)
{
    for (const auto& part : mesh.parts) {
        std::vector<Index> nodes;
        for (Index k = 0; k < part.elementCount; ++k)
            for (const Index node : mesh.hexahedra[std::size_t(part.firstElement + k)])
                nodes.push_back(node);
        std::ranges::sort(nodes);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        double extent = 0;
        for (std::size_t axis = 0; axis < 3 && !nodes.empty(); ++axis) {
            const auto [low, high] = std::ranges::minmax(
                nodes, {}, [&](Index node) { return mesh.points[std::size_t(node)][axis]; });
            extent = std::max(extent, mesh.points[std::size_t(high)][axis]
                                          - mesh.points[std::size_t(low)][axis]);
        }
        if (const auto count = surplusNodes(mesh, nodes, coincidence * extent); count > 0)
            log.warning(
                format("{}: {} nodes of part '{}' lie upon another node of it; is an interface "
                       "left unmerged?",
                       source, count, part.name));
    }
}

void checkOrphans(const Mesh& mesh, const std::string& source, Log& log)
{
    std::vector<char> used(mesh.points.size(), 0);
    for (const auto& hexahedron : mesh.hexahedra)
        for (const Index node : hexahedron) used[std::size_t(node)] = 1;
    if (const auto count = std::ranges::count(used, 0); count > 0)
        log.warning(
            format("{}: nodes that belong to no element and have no mass: {}", source, count));
}

} // namespace

void checkMesh(const Mesh& mesh, const std::string& source, Log& log)
{
    if (mesh.hexahedra.empty())
        throw Error(ExitCode::mesh, source + ": there are no hexahedra", "check the mesh's bodies");
    checkNodes(mesh, source);
    checkNumbers(mesh, source);
    checkShapes(mesh, source, log);
    checkCoincidentNodes(mesh, source, log);
    checkOrphans(mesh, source, log);
}

} // namespace fpm
