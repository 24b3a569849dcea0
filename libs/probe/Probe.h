#pragma once

#include "case/Case.h"
#include "probe/Times.h"

#include <filesystem>
#include <vector>

namespace fpm {

/// Which groups of probeDict are made, and for which output times.
struct ProbeSelection {
    bool tables = true, pictures = true, plots = true;
    TimeSelection times; ///< for pictures and tables; empty: what probeDict says
};

/// The work of fpmProbe: tables first, since plots may show them, then pictures, then plots. Reads
/// complete frames only, so it may run beside the solver. Prints the path of each file it makes and
/// returns them. Throws InputError, Error(dictionary) for unknown fields, parts and sets, and, once
/// the rest is made, Error(fileIo) for files that plots ask for and that do not exist.
std::vector<std::filesystem::path> runProbe(const Case& theCase,
                                            const Dictionary& dictionary,
                                            const ProbeSelection& selection,
                                            Log& log);

} // namespace fpm
