#include "io/Hdf5Seal.h"

#include "base/Error.h"
#include "io/Checksum.h"
#include "io/Hdf5File.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

namespace fpm {
namespace {

constexpr std::array<char, 8> plainMark{'f', 'p', 'm', 's', 'u', 'm', '1', '\n'};
/// With a label the last byte is its length.
constexpr std::array<char, 7> labelMark{'f', 'p', 'm', 's', 'u', 'm', '2'};

/// A regular file opened for reading. Never blocks on a pipe.
class InputFile
{
public:
    explicit InputFile(const std::filesystem::path& file)
        : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
    {
        struct stat status = {};
        if (number_ < 0 || ::fstat(number_, &status) != 0)
            fault_ = std::generic_category().message(errno);
        else if (!S_ISREG(status.st_mode))
            fault_ = "it is not a regular file";
        else
            size_ = std::uint64_t(status.st_size);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile()
    {
        if (number_ >= 0) ::close(number_);
    }

    std::uint64_t size() const { return size_; }
    const std::string& fault() const { return fault_; } ///< why it cannot be read; empty: it can

    /// Fills the buffer from `offset` on; false at an early end or a read error.
    bool read(std::uint64_t offset, std::span<std::byte> buffer) const
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

    /// Length of the label before the seal; nothing where there is no seal.
    std::optional<std::size_t> readSeal(hdf5::Seal& seal) const
    {
        if (!fault_.empty() || size_ < seal.size() || !read(size_ - seal.size(), seal))
            return std::nullopt;
        if (std::memcmp(seal.data(), plainMark.data(), plainMark.size()) == 0) return 0;
        if (std::memcmp(seal.data(), labelMark.data(), labelMark.size()) != 0) return std::nullopt;
        const auto length = std::to_integer<std::size_t>(seal[labelMark.size()]);
        if (size_ < seal.size() + length) return std::nullopt;
        return length;
    }

private:
    int number_;
    std::uint64_t size_ = 0;
    std::string fault_;
};

} // namespace

namespace hdf5 {

Seal makeSeal(std::uint64_t checksum, std::size_t labelLength)
{
    if (labelLength > std::numeric_limits<std::uint8_t>::max())
        throw Error(ExitCode::internal, "the label of a file is too long");
    Seal seal;
    std::memcpy(seal.data(), plainMark.data(), plainMark.size());
    if (labelLength > 0) {
        std::memcpy(seal.data(), labelMark.data(), labelMark.size());
        seal[labelMark.size()] = std::byte(labelLength);
    }
    std::memcpy(seal.data() + plainMark.size(), &checksum, sizeof checksum);
    return seal;
}

std::uint64_t verifySeal(const std::filesystem::path& file)
{
    const InputFile input(file);
    if (!input.fault().empty()) refuse(file, input.fault());
    Seal seal;
    const auto labelLength = input.readSeal(seal);
    if (!labelLength) refuse(file, "it does not end as a complete file of ours does");
    constexpr std::uint64_t blockSize = 1 << 20;
    const std::uint64_t end = input.size() - seal.size();
    std::vector<std::byte> buffer(std::size_t(std::min(blockSize, end)));
    Checksum checksum;
    for (std::uint64_t offset = 0; offset < end; offset += blockSize) {
        const auto block = std::span(buffer).first(std::size_t(std::min(blockSize, end - offset)));
        if (!input.read(offset, block)) refuse(file, "read error");
        checksum.add(block);
    }
    if (makeSeal(checksum.value(), *labelLength) != seal)
        refuse(file, "it is damaged: its checksum does not match");
    return input.size();
}

void refuse(const std::filesystem::path& file, const std::string& reason)
{
    throw Error(ExitCode::mesh, "cannot read '" + file.string() + "': " + reason,
                "files that are cut short, edited or made by other programs are refused; write it "
                "again with the utility that made it");
}

} // namespace hdf5

std::optional<std::string> hdf5Label(const std::filesystem::path& file)
{
    const InputFile input(file);
    hdf5::Seal seal;
    const auto length = input.readSeal(seal);
    if (!length) return std::nullopt;
    std::string label(*length, '\0');
    if (!input.read(input.size() - seal.size() - *length, std::as_writable_bytes(std::span(label))))
        return std::nullopt;
    return label;
}

} // namespace fpm
