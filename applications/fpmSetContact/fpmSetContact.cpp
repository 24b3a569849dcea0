#include "application/Application.h"
#include "mesh/MeshFile.h"
#include "model/ContactSetup.h"

/// Finds the nodes and faces of every contact pair: system/contactDict and constant/mesh.vtkhdf →
/// constant/mesh.vtkhdf with contact surfaces.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmSetContact",
        .purpose = "Finds the contact surfaces of system/contactDict in the mesh, reports their "
                   "sizes, gaps and overlaps, and stores them in constant/mesh.vtkhdf.",
        .dictionary = "system/contactDict",
        .options = {},
        .locksCase = true,
    };
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        fpm::Mesh mesh = fpm::readMesh(run.theCase.path(fpm::meshFile));
        fpm::setContact(mesh, run.dictionary(), run.theCase, run.log);
        fpm::writeMesh(run.theCase.output(), mesh);
    });
}
