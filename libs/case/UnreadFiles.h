#pragma once

#include "base/Log.h"
#include "case/Case.h"

namespace fpm {

/// A file in system, constant or 0 that no application reads and whose name is nearly that of
/// `relative`, or the same in another folder: "constant/boundaryCondition". Files that a dictionary
/// of the case includes, variants such as contactDict.fine and backups of editors are none. Empty
/// where there is none, or `relative` itself is there.
std::string lookalikeOf(const Case& theCase, const std::string& relative);

/// Warns of lookalikes of the files a run reads only where they are there. `dictionary`: the file
/// that -dict names, which is read; may be empty.
void warnOfUnreadFiles(const Case& theCase, const std::string& dictionary, Log& log);

} // namespace fpm
