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

} // namespace fpm
