#pragma once

#include "io/InputFile.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

/// The last 16 bytes of every HDF5 file of ours: a mark, with the length of a label before it, and
/// the checksum of all bytes before the seal.
/// HDF5 ignores everything beyond the end written in its header, so other programs see a plain
/// file; our reader finds damage before HDF5, which is not built for hostile bytes, reads the file.
namespace fpm::hdf5 {

using Seal = std::array<std::byte, 16>;

/// Throws Error(internal) for a label of more than 255 bytes.
Seal makeSeal(std::uint64_t checksum, std::size_t labelLength = 0);
/// Compares the seal of a file with the bytes before it; returns its label. Throws as
/// InputFile::requireReadable, and Error(mesh) for what is not complete or damaged.
std::string verifySeal(const InputFile& file);
/// Throws Error(mesh) saying that `file` cannot be read for `reason`.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason);

} // namespace fpm::hdf5
