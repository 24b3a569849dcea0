#include "mesher/FileBody.h"

#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/scaledJacobian.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fpm {

namespace {

[[noreturn]] void
refuse(const std::string& file, const std::string& what, const std::string& advice = "")
{
    throw Error(ExitCode::mesh, format("{}: {}", file, what), advice);
}

const char* kindOf(const PhysicalGroup& group)
{
    constexpr std::array<const char*, 4> kinds{"point", "curve", "surface", "volume"};
    return kinds.at(std::size_t(group.dimension));
}

std::string groupName(const std::string& body, const std::string& file, const PhysicalGroup& group)
{
    if (group.name.empty()) return format("{}.{}{}", body, kindOf(group), group.tag);
    if (!isName(group.name))
        refuse(file, format("physical {} {} is called '{}'; expected {}", kindOf(group), group.tag,
                            group.name, nameRule));
    return group.name;
}

/// Number of the volume group of each cell; all 0 where there is no such group.
std::vector<Index> partOfCells(const std::string& file, const ImportedMesh& imported)
{
    std::vector<Index> parts(imported.hexahedra.cells.size(), -1);
    Index count = 0;
    for (const auto& group : imported.groups) {
        if (group.dimension != 3) continue;
        for (const Index cell : group.cells) {
            if (parts[cell] >= 0)
                refuse(file,
                       format("hexahedron {} is in two physical volumes", imported.cellTags[cell]));
            parts[cell] = count;
        }
        ++count;
    }
    const auto loose = std::count(parts.begin(), parts.end(), -1);
    if (count > 0 && loose > 0)
        refuse(file, format("{} of {} hexahedra are in no physical volume", loose, parts.size()),
               "put every volume into a physical group, or none");
    if (count == 0) std::fill(parts.begin(), parts.end(), 0);
    return parts;
}

/// Refuses cells by the tags of the file, which is where they must be mended.
template <class Condition>
void refuseCells(const std::string& file,
                 const ImportedMesh& imported,
                 const std::string& fault,
                 const std::string& advice,
                 const Condition& isWrong)
{
    constexpr std::size_t listed = 10;
    const std::size_t all = imported.cellTags.size();
    std::string tags;
    std::size_t count = 0;
    for (std::size_t cell = 0; cell < all; ++cell) {
        if (!isWrong(Index(cell))) continue;
        if (count < listed) tags += (count > 0 ? ", " : "") + toText(imported.cellTags[cell]);
        ++count;
    }
    if (count == 0) return;
    refuse(file,
           format("{} of {} hexahedra {}: elements {}", count, all, fault,
                  tags + (count > listed ? ", ..." : "")),
           advice + " (the numbers are gmsh's element tags)");
}

/// Checks that checkMesh would make as well, but only with numbers that are not those of the file.
void checkCells(const std::string& file, const ImportedMesh& imported)
{
    Mesh mesh;
    mesh.points = imported.hexahedra.points;
    mesh.hexahedra = imported.hexahedra.cells;
    refuseCells(file, imported, "name a node twice",
                "wedges and pyramids written as hexahedra are not supported", [&](Index cell) {
                    auto nodes = mesh.hexahedra[cell];
                    std::sort(nodes.begin(), nodes.end());
                    return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
                });
    refuseCells(file, imported, "have no volume or a corner turned inside out",
                "mesh the region again; where it is all of them, list the bottom ring of nodes "
                "counter-clockwise seen from the top ring",
                [&](Index cell) {
                    const auto x = corners(mesh, cell);
                    for (const Point& corner : x)
                        for (const double coordinate : corner)
                            if (!std::isfinite(coordinate))
                                return false; // checkMesh names the node
                    return minScaledJacobian(x) <= 0 || volume(mesh, cell) <= 0;
                });
}

/// Cells part by part, in the order of the file within a part.
void addParts(Mesh& mesh,
              const std::string& body,
              const std::string& file,
              const ImportedMesh& imported)
{
    std::vector<std::string> names;
    for (const auto& group : imported.groups)
        if (group.dimension == 3) names.push_back(groupName(body, file, group));
    if (names.empty()) names.push_back(body);

    const auto parts = partOfCells(file, imported);
    for (Index part = 0; part < Index(names.size()); ++part) {
        const auto first = Index(mesh.hexahedra.size());
        for (std::size_t cell = 0; cell < parts.size(); ++cell)
            if (parts[cell] == part) mesh.hexahedra.push_back(imported.hexahedra.cells[cell]);
        const auto count = Index(mesh.hexahedra.size()) - first;
        if (count == 0) refuse(file, format("physical volume '{}' has no hexahedra", names[part]));
        mesh.parts.push_back({names[part], first, count});
    }
}

/// Every side of the mesh by its four nodes in ascending order.
class SideTable
{
public:
    explicit SideTable(const std::vector<Hexahedron>& cells) : cells_(cells)
    {
        entries_.reserve(6 * cells.size());
        for (Index element = 0; element < Index(cells.size()); ++element)
            for (Index side = 0; side < 6; ++side)
                entries_.push_back({key(sideNodes({element, side})), {element, side}});
        std::sort(entries_.begin(), entries_.end());
    }
    /// The side with these nodes whose outward normal has the direction of the quadrangle's, else
    /// the first, else -1.
    ElementSide find(const Quad& quad) const
    {
        const auto range =
            std::equal_range(entries_.begin(), entries_.end(), Entry{key(quad), {}},
                             [](const Entry& a, const Entry& b) { return a.nodes < b.nodes; });
        if (range.first == range.second) return {-1, -1};
        for (auto entry = range.first; entry != range.second; ++entry)
            if (sameTurn(sideNodes(entry->side), quad)) return entry->side;
        return range.first->side;
    }

private:
    struct Entry {
        Quad nodes;
        ElementSide side;
        auto operator<=>(const Entry&) const = default;
    };
    const std::vector<Hexahedron>& cells_;
    std::vector<Entry> entries_;

    Quad sideNodes(const ElementSide& side) const
    {
        Quad nodes;
        for (int corner = 0; corner < 4; ++corner)
            nodes[corner] = cells_[side.element][sideCorners[side.side][corner]];
        return nodes;
    }
    static Quad key(Quad nodes)
    {
        std::sort(nodes.begin(), nodes.end());
        return nodes;
    }
    static bool sameTurn(Quad a, const Quad& b)
    {
        std::rotate(a.begin(), std::find(a.begin(), a.end(), b[0]), a.end());
        return a == b;
    }
};

void addSideSet(Mesh& mesh,
                const std::string& name,
                const std::string& file,
                const PhysicalGroup& group,
                const SideTable& table)
{
    auto& sides = mesh.sideSets[name];
    Index strangers = 0;
    for (const Quad& quad : group.quads) {
        const ElementSide side = table.find(quad);
        strangers += side.element < 0;
        sides.push_back(side);
    }
    if (strangers > 0)
        refuse(file,
               format("{} of {} faces of physical surface '{}' are sides of no hexahedron",
                      strangers, sides.size(), name),
               "are the nodes of the surface and of the volume one and the same?");
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
}

} // namespace

bool isName(const std::string& text)
{
    constexpr std::size_t longest = 64;
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.+-";
    return !text.empty() && text.size() <= longest && text[0] != '.'
           && text.find_first_not_of(letters) == std::string::npos;
}

Mesh fileBody(const std::string& body, const std::string& file, const ImportedMesh& imported)
{
    checkCells(file, imported);
    Mesh mesh;
    mesh.points = imported.hexahedra.points;
    addParts(mesh, body, file, imported);

    const bool hasSurfaces = std::any_of(imported.groups.begin(), imported.groups.end(),
                                         [](const auto& group) { return group.dimension == 2; });
    const std::vector<Hexahedron> none;
    const SideTable table(hasSurfaces ? mesh.hexahedra : none);
    for (const auto& group : imported.groups) {
        if (group.dimension == 3) continue;
        const std::string name = groupName(body, file, group);
        if (mesh.sideSets.contains(name) || mesh.nodeSets.contains(name))
            refuse(file, format("two physical groups are called '{}'", name));
        if (group.dimension == 2) {
            addSideSet(mesh, name, file, group, table);
            continue;
        }
        auto& nodes = mesh.nodeSets[name] = group.nodes;
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
    return mesh;
}

} // namespace fpm
