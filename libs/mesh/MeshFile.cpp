#include "mesh/MeshFile.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/Checksum.h"
#include "io/FrameLabel.h"
#include "io/Hdf5File.h"
#include "mesh/Patches.h"

#include <algorithm>
#include <limits>

namespace fpm {
namespace {

constexpr std::int64_t formatVersion = 1;

std::span<const Index> flat(const std::vector<ElementSide>& sides)
{
    static_assert(sizeof(ElementSide) == 2 * sizeof(Index));
    return {sides.empty() ? nullptr : &sides.front().element, 2 * sides.size()};
}

std::vector<Index> partOfElements(const Mesh& mesh)
{
    std::vector<Index> numbers(mesh.hexahedra.size());
    for (std::size_t part = 0; part < mesh.parts.size(); ++part)
        std::fill_n(numbers.begin() + mesh.parts[part].firstElement, mesh.parts[part].elementCount,
                    Index(part));
    return numbers;
}

std::vector<Index> patchOfElements(const Mesh& mesh)
{
    std::vector<Index> numbers(mesh.hexahedra.size());
    for (std::size_t patch = 0; patch + 1 < mesh.patchStarts.size(); ++patch)
        std::fill(numbers.begin() + mesh.patchStarts[patch],
                  numbers.begin() + mesh.patchStarts[patch + 1], Index(patch));
    return numbers;
}

void writeContact(Hdf5Image& image, const Mesh& mesh)
{
    image.attribute("/fpm/contact", "key", mesh.contactKey);
    for (std::size_t number = 0; number < mesh.contact.size(); ++number) {
        const auto& surfaces = mesh.contact[number];
        const std::string group = "/fpm/contact/" + surfaces.pair;
        image.attribute(group, "order", std::array<std::int64_t, 1>{std::int64_t(number)});
        image.write(group + "/contactorNodes", std::span<const Index>(surfaces.contactorNodes));
        image.write(group + "/contactorSides", flat(surfaces.contactorSides), 2);
        image.write(group + "/targetSides", flat(surfaces.targetSides), 2);
    }
}

} // namespace

std::string meshChecksum(const Mesh& mesh)
{
    Checksum checksum;
    checksum.add(mesh.points);
    checksum.add(mesh.hexahedra);
    checksum.addNumber(mesh.parts.size());
    for (const auto& part : mesh.parts) {
        checksum.add(part.name);
        checksum.addNumber(std::uint64_t(part.firstElement));
        checksum.addNumber(std::uint64_t(part.elementCount));
    }
    checksum.add(mesh.patchStarts);
    checksum.addNumber(mesh.nodeSets.size());
    for (const auto& [name, nodes] : mesh.nodeSets) {
        checksum.add(name);
        checksum.add(nodes);
    }
    checksum.addNumber(mesh.sideSets.size());
    for (const auto& [name, sides] : mesh.sideSets) {
        checksum.add(name);
        checksum.add(sides);
    }
    return checksum.text();
}

FrameMesh frameMesh(const Mesh& mesh)
{
    return {meshChecksum(mesh), mesh.points.size(), mesh.hexahedra.size()};
}

void writeMesh(const OutputFolder& theCase, const Mesh& mesh)
{
    Hdf5Image image;
    writeGrid(image, mesh.points, mesh.hexahedra);
    image.write("/VTKHDF/CellData/Part", std::span<const Index>(partOfElements(mesh)));
    image.write("/VTKHDF/CellData/Patch", std::span<const Index>(patchOfElements(mesh)));
    image.attribute("/fpm", "version", std::array<std::int64_t, 1>{formatVersion});
    const FrameLabel label{std::nullopt, meshChecksum(mesh), true};
    image.attribute("/fpm", "meshChecksum", label.mesh);
    image.write("/fpm/patchStarts", std::span<const Index>(mesh.patchStarts));
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        const auto& [name, first, count] = mesh.parts[part];
        image.write("/fpm/parts/" + name, std::array<Index, 3>{Index(part), first, count});
    }
    for (const auto& [name, nodes] : mesh.nodeSets)
        image.write("/fpm/nodeSets/" + name, std::span<const Index>(nodes));
    for (const auto& [name, sides] : mesh.sideSets)
        image.write("/fpm/sideSets/" + name, flat(sides), 2);
    writeContact(image, mesh);
    image.save(theCase, meshFile, label.text());
}

} // namespace fpm
