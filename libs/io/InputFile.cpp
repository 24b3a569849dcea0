#include "io/InputFile.h"

#include "base/Error.h"
#include "base/Format.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace fpm {

InputFile::InputFile(const std::filesystem::path& file)
    : name_(file),
      number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
{
    struct stat status = {};
    if (number_ < 0 || ::fstat(number_, &status) != 0)
        fault_ = readObstacle(file, cause_ = errno);
    else if (S_ISDIR(status.st_mode))
        fault_ = readObstacle(file, EISDIR);
    else if (!S_ISREG(status.st_mode))
        fault_ = {"it is not a regular file", "put the file itself in its place"};
    else
        size_ = std::uint64_t(status.st_size);
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)),
      number_(std::exchange(other.number_, -1)),
      size_(other.size_),
      fault_(std::move(other.fault_)),
      cause_(other.cause_)
{
}

InputFile::~InputFile()
{
    if (number_ >= 0) ::close(number_);
}

void InputFile::requireReadable() const
{
    if (isReadable()) return;
    const bool isMissing = cause_ == 0 || cause_ == ENOENT || cause_ == ENOTDIR;
    throw Error(isMissing ? ExitCode::mesh : ExitCode::fileIo,
                format("cannot read '{}': {}", name_.string(), fault_.reason), fault_.advice);
}

std::string InputFile::descriptorPath() const
{
    return "/proc/self/fd/" + std::to_string(number_);
}

bool InputFile::read(std::uint64_t offset, std::span<std::byte> buffer) const
{
    while (!buffer.empty()) {
        const ssize_t count = ::pread(number_, buffer.data(), buffer.size(), off_t(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        offset += std::uint64_t(count);
        buffer = buffer.subspan(std::size_t(count));
    }
    return true;
}

} // namespace fpm
