#pragma once

#include "base/Error.h"

#include <filesystem>

namespace fpm {

/// A file or folder that could not be written, renamed or removed: Error(fileIo).
class FileError : public Error
{
public:
    /// "cannot <action> '<file>': <what the system says>", with an advice for this cause.
    FileError(const std::string& action, const std::filesystem::path& file, int cause);
    /// Where it is not the system that refuses.
    FileError(const std::string& message,
              const std::string& advice,
              const std::filesystem::path& file);

    const std::filesystem::path& file() const { return file_; }
    /// No room on the disk, or none left of the quota: it may come back.
    bool isFullDisk() const;

private:
    std::filesystem::path file_;
    int cause_ = 0; ///< of the system, as errno
};

} // namespace fpm
