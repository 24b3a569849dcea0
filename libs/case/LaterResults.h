#pragma once

#include "base/Log.h"
#include "io/OutputFolder.h"

#include <string>

namespace fpm {

/// Folder of a case with what a run had left beyond the checkpoint that it went on from.
inline constexpr const char* laterFolder = "later";

/// Moves there the frames of a run later than `time`, the state that stopped it and why.txt, each
/// in place of an earlier one of its name. Logs one line where there is any.
void setLaterResultsAside(const OutputFolder& theCase,
                          const std::string& runId,
                          double time,
                          Log& log);

} // namespace fpm
