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
        {}; ///< of the mesh; when empty, writeFrame takes it from the mesh file
};

/// Adds a static VTKHDF UnstructuredGrid (Version 1 0) of hexahedra under /VTKHDF.
void writeGrid(Hdf5Image& image,
               std::span<const Point> points,
               std::span<const std::array<Index, 8>> hexahedra);

/// <case>/<time>/fields.vtkhdf, linked to ../constant/mesh.vtkhdf, then case.vtkhdf.series and
/// case.hdf.series (list of committed times, JSON); `timeName` is the folder.
void writeFrame(const std::filesystem::path& caseRoot,
                const std::string& timeName,
                const Frame& frame,
                std::size_t nodeCount,
                std::size_t elementCount);
/// Fields in alphabetical order. Takes nothing but the fields from the file: links to the mesh are
/// not followed. Throws Error(mesh) for a damaged file.
Frame readFrame(const std::filesystem::path& file);

/// Output times of a case in ascending order: folder name and value; only complete frames.
std::vector<std::pair<std::string, double>> frameTimes(const std::filesystem::path& caseRoot);
/// Rewrites case.vtkhdf.series and case.hdf.series from what lies in the time folders.
void writeSeries(const std::filesystem::path& caseRoot);
/// Folder name of a time, as printf %.12g ("0", "0.00015", "5e-05"): free of rounding noise, and
/// unique while output times are more than 1e-12 of their value apart.
std::string timeName(double time);

} // namespace fpm
