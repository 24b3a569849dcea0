#pragma once

#include <filesystem>
#include <string_view>

namespace fpm {

/// `root`/`relative`, which need not exist yet. Throws Error(fileIo) when `relative` is absolute,
/// holds "..", or passes a link that leads out of `root` (which must be canonical).
std::filesystem::path confinedPath(const std::filesystem::path& root, std::string_view relative);

/// Whether `path` lies in or under `folder`, both canonical.
bool isBeneath(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace fpm
