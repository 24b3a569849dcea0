#include "base/Log.h"
#include "fuzz/tried.h"
#include "mesher/FileBody.h"
#include "mesher/ImportedMesh.h"
#include "mesher/MshText.h"
#include "support/TemporaryFolder.h"

// Any text is refused as a Gmsh file, or read by gmsh in a child process, and then a body with sets
// or refused.

using namespace fpm;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    static const test::TemporaryFolder folder;
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    fuzz::tried([&] {
        checkMshText("input", text);
        const auto file = folder / "input.msh";
        test::writeBytes(file, text);
        const Mesh mesh = fileBody("body", "input", importMesh(file, "input", false));
        for (const auto& corners : mesh.hexahedra)
            for (const Index node : corners)
                fuzz::require(std::size_t(node) < mesh.points.size(), "corners are nodes");
    });
    return 0;
}
