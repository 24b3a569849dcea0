#include "fuzz/ImageEdits.h"
#include "fuzz/tried.h"
#include "mesh/MeshFile.h"
#include "mesh/Patches.h"
#include "mesh/Surface.h"
#include "support/TemporaryFolder.h"
#include "support/boxMesh.h"

// A mesh file whose arrays and attributes say anything is a mesh in which every number points at
// something, or refused. The input is a list of edits of a small mesh.

using namespace fpm;

namespace {

Mesh smallMesh()
{
    Mesh mesh;
    test::addBox(mesh, "rod", {2, 1, 1});
    test::addBox(mesh, "plate", {1, 1, 1}, {0, 0, 2});
    mesh.sideSets["skin"] = skin(mesh, 0);
    mesh.nodeSets["tip"] = {3, 5};
    renumber(mesh);
    mesh.contact.push_back({"pair", {1, 2}, {{0, 1}}, {{2, 0}}});
    mesh.contactKey = "key";
    return mesh;
}

/// The file that is edited.
struct Base {
    test::TemporaryFolder folder;
    std::string label;
    fuzz::ImageEdits content;

    Base()
        : label((writeMesh(OutputFolder(folder.path()), smallMesh()), *hdf5Label(file()))),
          content(file(), {"version", "meshChecksum", "key", "order", "Version", "Type"})
    {
    }
    std::filesystem::path file() const { return folder / meshFile; }
};

void requireSound(const Mesh& mesh)
{
    const auto isNode = [&](Index node) { return std::size_t(node) < mesh.points.size(); };
    const auto isElement = [&](Index number) {
        return std::size_t(number) < mesh.hexahedra.size();
    };
    for (const auto& corners : mesh.hexahedra)
        for (const Index node : corners) fuzz::require(isNode(node), "corners are nodes");
    for (const auto& [name, nodes] : mesh.nodeSets)
        for (const Index node : nodes) fuzz::require(isNode(node), "node sets hold nodes");
    for (const auto& [name, sides] : mesh.sideSets)
        for (const auto& side : sides) fuzz::require(isElement(side.element), "sides of elements");
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) skin(mesh, Index(part));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    static const Base base;
    fuzz::InputBytes input(bytes, size);
    fuzz::ImageEdits edits = base.content;
    edits.apply(input);
    const auto file = base.folder / "edited.vtkhdf";
    edits.write(base.folder.path(), "edited.vtkhdf", base.label);
    fuzz::tried([&] { requireSound(readMesh(file)); });
    return 0;
}
