#pragma once

#include "io/Descriptor.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

/// Checked writing to an open file; `path` is for messages. All throw FileError.
namespace fpm {

/// One call of the system where it takes all at once.
void writeAll(const Descriptor& out,
              std::span<const std::byte> bytes,
              const std::filesystem::path& path);
/// What is left of one open file into another.
void copyAll(const Descriptor& in,
             const std::filesystem::path& from,
             const Descriptor& out,
             const std::filesystem::path& path);
/// Takes the space first, so that a full disk is found before anything is written. File systems
/// that cannot say so, and the write finds out.
void reserve(const Descriptor& out, std::uint64_t size, const std::filesystem::path& path);
/// Waits until content and size are on the disk.
void synchronise(const Descriptor& out, const std::filesystem::path& path);

} // namespace fpm
