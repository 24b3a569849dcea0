#include "io/InputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace fpm {

InputFile::InputFile(const std::filesystem::path& file)
    : name_(file),
      number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
{
    struct stat status = {};
    if (number_ < 0 || ::fstat(number_, &status) != 0)
        fault_ = std::generic_category().message(errno);
    else if (!S_ISREG(status.st_mode))
        fault_ = "it is not a regular file";
    else
        size_ = std::uint64_t(status.st_size);
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)),
      number_(std::exchange(other.number_, -1)),
      size_(other.size_),
      fault_(std::move(other.fault_))
{
}

InputFile::~InputFile()
{
    if (number_ >= 0) ::close(number_);
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
