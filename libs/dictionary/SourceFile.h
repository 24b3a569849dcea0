#pragma once

#include "dictionary/Document.h"

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace fpm {

/// Why a file was not read: refused by a rule of ours, or the system could not.
struct ReadFailure {
    bool isRefused;
    std::string reason;
    std::string advice = "";
};

/// The bytes of a regular file, and its identity on this machine.
struct FileContent {
    std::string bytes;
    std::filesystem::path path; ///< without links
    std::string name;           ///< relative to the root it was confined to
    dev_t device;
    ino_t number;
};

/// Reads `file`, which must be a regular file of at most `mostBytes` beneath `root` once every link
/// is followed; a pipe or device is never waited for. Throws ReadFailure.
FileContent readConfined(const std::filesystem::path& file,
                         const std::filesystem::path& root,
                         std::uint64_t mostBytes);

/// Drops a byte order mark and makes every line end "\n".
void normaliseText(std::string& text);

/// Throws Fault at the first NUL or byte that is not UTF-8; `number` is that of `source`.
void requireText(const Source& source, std::uint16_t number);

} // namespace fpm
