#include "io/FileError.h"

#include <cerrno>
#include <system_error>

namespace fpm {
namespace {

std::string adviceFor(int cause)
{
    switch (cause) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "free some space or quota; what was there before is untouched";
    case EACCES:
    case EPERM:
        return "it must be yours to write, and so must its folder: see ls -ld and chmod u+w, or "
               "work in a copy of the case";
    case EROFS:
        return "the disk is mounted for reading only: work in a copy of the case";
    case EIO:
        return "the disk or its server fails: save what there is; what was there before is "
               "untouched";
    default:
        return "check free space, quota and permissions; what was there before is untouched";
    }
}

} // namespace

FileError::FileError(const std::string& action, const std::filesystem::path& file, int cause)
    : Error(ExitCode::fileIo,
            "cannot " + action + " '" + file.string()
                + "': " + std::generic_category().message(cause),
            adviceFor(cause)),
      file_(file),
      cause_(cause)
{
}

FileError::FileError(const std::string& message,
                     const std::string& advice,
                     const std::filesystem::path& file)
    : Error(ExitCode::fileIo, message, advice),
      file_(file)
{
}

bool FileError::isFullDisk() const
{
    return cause_ == ENOSPC || cause_ == EDQUOT;
}

} // namespace fpm
