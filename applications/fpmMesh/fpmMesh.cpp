#include "application/Application.h"
#include "base/Format.h"
#include "case/PreviousRun.h"
#include "mesh/MeshFile.h"
#include "mesher/Mesher.h"

/// Meshes the bodies of system/meshDict with hexahedra and writes constant/mesh.vtkhdf.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        "fpmMesh",
        "Meshes the bodies of system/meshDict with hexahedra and writes constant/mesh.vtkhdf.",
        "system/meshDict",
        {{"allowGeo", "", "Run .geo files named in meshDict; they are programs, so trust them"}},
        true};

    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        const fpm::Mesh mesh =
            fpm::makeMesh(run.dictionary(), run.theCase, run.has("allowGeo"), run.log);
        fpm::keepMeshOfFrames(run.theCase.root());
        fpm::writeMesh(run.theCase.output(), mesh);
        run.log.line(
            fpm::format("wrote {}: {} elements, {} nodes, {} parts, {} side sets, {} node sets",
                        fpm::meshFile, mesh.hexahedra.size(), mesh.points.size(), mesh.parts.size(),
                        mesh.sideSets.size(), mesh.nodeSets.size()));
    });
}
