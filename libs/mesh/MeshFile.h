#pragma once

#include "io/OutputFolder.h"
#include "io/VtkHdf.h"
#include "mesh/Mesh.h"

#include <filesystem>

namespace fpm {

/// Where the mesh of a case lies.
inline constexpr const char* meshFile = "constant/mesh.vtkhdf";

/// constant/mesh.vtkhdf: a grid ParaView opens (cell data "Part", "Patch", "ElementId", point data
/// "NodeId"), and under /fpm parts, patches, sets, contact surfaces and a checksum over all of it.
/// Complete or absent.
void writeMesh(const OutputFolder& theCase, const Mesh& mesh);
/// Throws Error(mesh): not there (advice: run fpmMesh), damaged, wrong version, lying counts.
Mesh readMesh(const std::filesystem::path& file);
/// Checksum of coordinates, connectivity, parts and sets (not of the contact surfaces).
std::string meshChecksum(const Mesh& mesh);
/// What frames of a run with this mesh must fit.
FrameMesh frameMesh(const Mesh& mesh);

} // namespace fpm
