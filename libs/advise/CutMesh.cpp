#include "advise/CutMesh.h"

#include "mesh/Patches.h"

#include <algorithm>

namespace fpm {

Cut::Cut(const Mesh& mesh, std::vector<MirrorPlane> planes, std::vector<int> sides)
    : planes_(std::move(planes)),
      sides_(std::move(sides)),
      tolerance_(mirrorTolerance(mesh))
{
}

double Cut::height(std::size_t plane, const Point& point) const
{
    return sides_[plane] * (point[planes_[plane].axis] - planes_[plane].place);
}

bool Cut::keeps(const Point& point) const
{
    for (std::size_t i = 0; i < planes_.size(); ++i)
        if (height(i, point) < -tolerance_) return false;
    return true;
}

bool Cut::keeps(const Mesh& mesh, Index element) const
{
    const Hexahedron& nodes = mesh.hexahedra[std::size_t(element)];
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](Index node) { return keeps(mesh.points[std::size_t(node)]); });
}

bool Cut::isOn(std::size_t plane, const Point& point) const
{
    const double h = height(plane, point);
    return h <= tolerance_ && h >= -tolerance_;
}

std::size_t Cut::planesAt(const Point& point) const
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i) count += isOn(i, point);
    return count;
}

Point Cut::kept(Point point) const
{
    for (std::size_t i = 0; i < planes_.size(); ++i)
        if (height(i, point) < 0) point = planes_[i].image(point);
    return point;
}

Mesh cutMesh(const Mesh& mesh, const Cut& cut)
{
    Mesh out;
    out.points = mesh.points;
    for (Point& point : out.points)
        for (std::size_t i = 0; i < cut.planes().size(); ++i)
            if (cut.isOn(i, point)) point[cut.planes()[i].axis] = cut.planes()[i].place;
    std::vector<Index> number(mesh.hexahedra.size(), -1);
    for (const MeshPart& part : mesh.parts) {
        const auto first = Index(out.hexahedra.size());
        for (Index e = part.firstElement; e < part.firstElement + part.elementCount; ++e) {
            if (!cut.keeps(mesh, e)) continue;
            number[std::size_t(e)] = Index(out.hexahedra.size());
            out.hexahedra.push_back(mesh.hexahedra[std::size_t(e)]);
        }
        out.parts.push_back({part.name, first, Index(out.hexahedra.size()) - first});
    }
    std::vector<bool> used(mesh.points.size(), false);
    for (const Hexahedron& nodes : out.hexahedra)
        for (const Index node : nodes) used[std::size_t(node)] = true;
    for (const auto& [name, nodes] : mesh.nodeSets) {
        std::vector<Index>& kept = out.nodeSets[name];
        for (const Index node : nodes)
            if (used[std::size_t(node)]) kept.push_back(node);
    }
    for (const auto& [name, sides] : mesh.sideSets) {
        std::vector<ElementSide>& kept = out.sideSets[name];
        for (const ElementSide& side : sides)
            if (number[std::size_t(side.element)] >= 0)
                kept.push_back({number[std::size_t(side.element)], side.side});
    }
    renumber(out);
    return out;
}

} // namespace fpm
