#include "io/Frames.h"
#include "io/VtkHdf.h"
#include "mesh/MeshFile.h"
#include "mesh/Patches.h"
#include "support/boxMesh.h"

#include <cstdio>
#include <exception>

using namespace fpm;

/// Writes the case folder that readVtk.py reads: two parts, two times. Fields are simple functions
/// of the coordinates, which the script evaluates too.
static void writeExample(const std::filesystem::path& folder)
{
    Mesh mesh;
    test::addBox(mesh, "lower", {4, 3, 2}, {0, 0, 0}, {4, 3, 2});
    test::addBox(mesh, "upper", {2, 2, 1}, {0, 0, 2}, {4, 3, 1});
    renumber(mesh);
    const OutputFolder output = OutputFolder::make(folder);
    writeMesh(output, mesh);
    for (const double time : {0.0, 5e-5}) {
        Frame frame;
        frame.time = time;
        frame.runId = "one";
        ResultField displacement{"U", 3, {}}, stress{"S", 6, {}}, strain{"PEEQ", 1, {}};
        for (const auto& x : mesh.points)
            for (const double one : {x[1], -x[0], 0.5 * x[2]})
                displacement.values.push_back(1e4 * time * one);
        for (std::size_t element = 0; element < mesh.hexahedra.size(); ++element) {
            strain.values.push_back(time + double(element));
            for (int component = 1; component <= 6; ++component)
                stress.values.push_back(double(component) + double(element));
        }
        frame.nodeFields = {displacement};
        frame.elementFields = {stress, strain};
        writeFrame(output, timeName(time), frame, mesh.points.size(), mesh.hexahedra.size());
    }
    writeSeries(output, "one", {timeName(0), timeName(5e-5)});
}

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    try {
        writeExample(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
