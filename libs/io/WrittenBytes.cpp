#include "io/WrittenBytes.h"

#include "io/FileError.h"

#include <fcntl.h>

#include <vector>

namespace fpm {

void writeAll(const Descriptor& out,
              std::span<const std::byte> bytes,
              const std::filesystem::path& path)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(out.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw FileError("write", path, errno);
        if (written == 0) throw FileError("write", path, ENOSPC);
        bytes = bytes.subspan(std::size_t(written));
    }
}

void copyAll(const Descriptor& in,
             const std::filesystem::path& from,
             const Descriptor& out,
             const std::filesystem::path& path)
{
    std::vector<std::byte> buffer(std::size_t(1) << 20);
    for (;;) {
        const ssize_t count = ::read(in.number(), buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError("read", from, errno);
        if (count == 0) return;
        writeAll(out, std::span(buffer).first(std::size_t(count)), path);
    }
}

void reserve(const Descriptor& out, std::uint64_t size, const std::filesystem::path& path)
{
    if (size == 0) return;
    int code = EINTR;
    while (code == EINTR) code = ::posix_fallocate(out.number(), 0, off_t(size));
    if (code == ENOSPC || code == EDQUOT || code == EFBIG || code == EIO)
        throw FileError("write", path, code);
}

void synchronise(const Descriptor& out, const std::filesystem::path& path)
{
    int result = ::fsync(out.number());
    while (result != 0 && errno == EINTR) result = ::fsync(out.number());
    if (result != 0) throw FileError("write", path, errno);
}

} // namespace fpm
