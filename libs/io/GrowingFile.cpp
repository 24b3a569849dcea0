#include "io/GrowingFile.h"

#include "base/Format.h"
#include "io/FileError.h"
#include "io/WrittenBytes.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace fpm {
namespace {

std::uint64_t sizeOf(const Descriptor& file, const std::filesystem::path& path)
{
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) throw FileError("read", path, errno);
    return std::uint64_t(status.st_size);
}

/// The first bytes of a file; fewer where it ends before.
std::string firstBytes(const Descriptor& file, std::size_t count, const std::filesystem::path& path)
{
    std::string bytes(count, '\0');
    std::size_t have = 0;
    while (have < count) {
        const ssize_t more = ::pread(file.number(), bytes.data() + have, count - have, off_t(have));
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) throw FileError("read", path, errno);
        if (more == 0) break;
        have += std::size_t(more);
    }
    bytes.resize(have);
    return bytes;
}

} // namespace

GrowingFile::GrowingFile(const OutputFolder& output, const std::string& file, int flags)
    : output_(output),
      path_(output.path(file)),
      out_(output.open(file, flags))
{
}

GrowingFile::GrowingFile(const OutputFolder& output, const std::string& file)
    : GrowingFile(output, file, O_WRONLY | O_CREAT | O_APPEND)
{
    cut(0);
}

GrowingFile GrowingFile::resume(const OutputFolder& output,
                                const std::string& file,
                                std::string_view head,
                                std::uint64_t size)
{
    GrowingFile resumed(output, file, O_RDWR | O_APPEND);
    const auto& path = resumed.path_;
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitCode::checkpoint, format("cannot go on with '{}': {}", path.string(), why),
                    "it is not the file this run left; start the run from the beginning");
    };
    const std::uint64_t there = sizeOf(resumed.out_, path);
    if (there < size) refuse(format("it has {} bytes, and {} at the checkpoint", there, size));
    if (size < head.size() || firstBytes(resumed.out_, head.size(), path) != head)
        refuse("its head is not that of this run");
    resumed.cut(size);
    resumed.size_ = size;
    return resumed;
}

void GrowingFile::append(std::string_view text)
{
    output_.fullDisk().attempt(path_, [&] {
        try {
            writeAll(out_, std::as_bytes(std::span(text)), path_);
        } catch (const FileError&) {
            cut(size_);
            throw;
        }
    });
    size_ += text.size();
}

void GrowingFile::synchronise() const
{
    fpm::synchronise(out_, path_);
}

void GrowingFile::cut(std::uint64_t size) const
{
    if (::ftruncate(out_.number(), off_t(size)) != 0) throw FileError("write", path_, errno);
}

} // namespace fpm
