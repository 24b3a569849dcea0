#pragma once

#include <filesystem>
#include <string>

namespace fpm {

/// Why a file or folder cannot be read, and what helps.
struct ReadObstacle {
    std::string reason; ///< "permission denied: '/x/system' belongs to anna, drwx------"
    std::string advice; ///< may be empty
};

/// Of a path that the system refused to open with `error` (as errno).
ReadObstacle readObstacle(const std::filesystem::path& path, int error);

} // namespace fpm
