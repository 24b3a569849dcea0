#pragma once

#include "base/Types.h"
#include "io/Hdf5File.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace fpm {

/// A result array: `columns` values a node or element, in float32 on disk.
struct ResultField {
    std::string name;        ///< "U", "V", "S", "PEEQ", "Mises", ...
    std::size_t columns = 1; ///< 1, 3 or 6 (S: XX YY ZZ XY YZ XZ)
    std::vector<double> values;
};

/// One output time: fields on nodes and elements of the mesh in constant/mesh.vtkhdf.
struct Frame {
    double time = 0;
    std::vector<ResultField> nodeFields, elementFields;
    std::string meshChecksum =
        {};                 ///< of the mesh; when empty, writeFrame takes it from the mesh file
    std::string runId = {}; ///< of the run that writes it
};

/// Adds a static VTKHDF UnstructuredGrid (Version 1 0) of hexahedra under /VTKHDF, with the numbers
/// of nodes and elements, from 0 as in messages: point data NodeId, cell data ElementId.
void writeGrid(Hdf5Image& image,
               std::span<const Point> points,
               std::span<const std::array<Index, 8>> hexahedra);

/// <time>/fields.vtkhdf in a case, linked to ../constant/mesh.vtkhdf; `timeName` is the folder. The
/// numbers of nodes and elements are links too, where the mesh file has them.
void writeFrame(const OutputFolder& theCase,
                const std::string& timeName,
                const Frame& frame,
                std::size_t nodeCount,
                std::size_t elementCount);

/// The mesh that the fields of a frame must belong to.
struct FrameMesh {
    std::string checksum;
    std::size_t nodeCount = 0, elementCount = 0;
};

/// Fields in alphabetical order. Takes nothing but the fields from the file: links to the mesh are
/// not followed. Throws Error(mesh) for a damaged file, one whose label and content name different
/// runs or meshes, and one of another mesh.
Frame readFrame(const std::filesystem::path& file, const FrameMesh& mesh);

} // namespace fpm
