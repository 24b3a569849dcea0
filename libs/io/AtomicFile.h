#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace fpm {

/// Makes `file` hold exactly `bytes`, or leaves what was there: temporary (hidden) file beside it,
/// checked write loop, fsync, rename, fsync of the directory. Throws Error(fileIo). Creates
/// folders.
void writeFileAtomically(const std::filesystem::path& file, std::span<const std::byte> bytes);
void writeFileAtomically(const std::filesystem::path& file, std::string_view text);
/// The same without waiting for the disk, for what is written every second: after a loss of power
/// the file may be empty.
void renewFile(const std::filesystem::path& file, std::string_view text);

/// Removes from a folder the temporary files that killed writers left; of `deadOnly`, those whose
/// process no longer exists on this machine. The caller guarantees that no other writer works
/// there. Returns the number removed.
int removeTemporaries(const std::filesystem::path& folder, bool deadOnly);

} // namespace fpm
