#pragma once

#include "base/Log.h"
#include "io/OutputFolder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fpm {

/// Folder of a case with the results of the run before the present one, laid out as in the case.
inline constexpr const char* previousFolder = "previous";

/// Files in a case, relative to it, that its runs and fpmProbe made: frames, histories, tables,
/// pictures, plots and records by the mark they bear, `status`, why.txt, series and what older
/// versions left by name. Links, and what lies behind them, are none.
std::vector<std::string> resultFiles(const std::filesystem::path& caseRoot);

/// Whether the folder `previous` of a case was made by clearForRun.
bool isPreviousRun(const std::filesystem::path& folder);

/// Clears the case for a run; the caller holds the case lock. `mode`: keep moves the results of an
/// earlier run into `previous`, replacing those of the run before; remove deletes them; refuse
/// throws Error(fileIo) if there are any. Logs one line about it. If it is killed, the next call
/// completes it. Throws Error(fileIo) where `previous` was not made by a run, and where it or
/// postProcessing is a link, through which nothing is written.
void clearForRun(const OutputFolder& theCase, const std::string& mode, Log& log);

/// Called before the mesh is replaced: frames in the case are shown through a link to it, so it is
/// kept until they go into `previous`.
void keepMeshOfFrames(const std::filesystem::path& caseRoot);

/// Removes the temporary files that killed programs left in a case; the caller holds its lock.
void sweepTemporaries(const std::filesystem::path& caseRoot);

} // namespace fpm
