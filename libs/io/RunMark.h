#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fpm {

/// Origin of a result file: "fpm run <id> <file>", the file relative to its case. It identifies a
/// copy under another name.
struct RunMark {
    std::string runId; ///< empty where no run wrote the file
    std::string file;
    std::string text() const;
};

/// The first mark in a text.
std::optional<RunMark> findMark(std::string_view text);
/// The mark in the first kilobyte of a regular file that is no link.
std::optional<RunMark> markOf(const std::filesystem::path& file);

} // namespace fpm
