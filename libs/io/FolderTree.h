#pragma once

#include "io/OutputFolder.h"

namespace fpm {

/// Removes a folder with all it holds, or does nothing where it is not there. Links in it are
/// removed, not followed. Throws Error(fileIo) where something else than a folder has this name,
/// and where a disk is mounted in it, which is left as it is.
void removeTree(const OutputFolder& output, std::string_view folder);

/// Removes from a folder the temporary files that killed writers left; of `deadOnly`, those whose
/// process no longer exists on this machine. The caller guarantees that no other writer works
/// there. Returns the number removed: none in a folder that is not there, is a link or is not
/// ours to read.
int removeTemporaries(const OutputFolder& output, std::string_view folder, bool deadOnly);

} // namespace fpm
