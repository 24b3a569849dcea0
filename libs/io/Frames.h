#pragma once

#include "io/OutputFolder.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace fpm {

using FrameTime = std::pair<std::string, double>; ///< folder of an output time, its value

/// <time>/fields.vtkhdf as it lies in a case.
struct FrameFile {
    FrameTime time;
    std::string runId;        ///< of the run that wrote it; empty where it names none
    std::string meshChecksum; ///< of the mesh it belongs to
};

/// Every frame of a case in ascending order, whatever run it is of. Throws Error(mesh) naming a
/// frame that is cut short; damage inside of one shows when it is read.
std::vector<FrameFile> listFrames(const std::filesystem::path& caseRoot);
/// Whether `file`, relative to the case, is a frame that the solver wrote there: by its mark, or in
/// a time folder, where it has none or is cut short, by its first bytes. Links are none.
bool isFrame(const std::filesystem::path& caseRoot, const std::string& file);

/// Checksum in a mesh file; empty where there is no such file. Throws Error(mesh) for a damaged
/// one.
std::string meshChecksumIn(const std::filesystem::path& file);
/// Of constant/mesh.vtkhdf.
std::string meshChecksumOf(const std::filesystem::path& caseRoot);

/// Whether constant/mesh.vtkhdf holds NodeId and ElementId, as writeGrid leaves them.
bool meshHasIds(const std::filesystem::path& caseRoot);

/// Writes case.vtkhdf.series and, for ParaView before 5.12, case.hdf.series: JSON with the run and
/// the time folders given.
void writeSeries(const OutputFolder& theCase,
                 const std::string& runId,
                 const std::vector<std::string>& folders);

/// Folder name of a time, as printf %.12g ("0", "0.00015", "5e-05"): free of rounding noise, and
/// unique while output times are more than 1e-12 of their value apart.
std::string timeName(double time);

} // namespace fpm
