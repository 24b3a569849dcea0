#include "dictionary/SourceFile.h"

#include "base/Format.h"
#include "base/ReadObstacle.h"
#include "base/Utf8.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace fpm {

namespace {

namespace fs = std::filesystem;

class Descriptor
{
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number_ >= 0) close(number_);
    }
    int number() const { return number_; }

private:
    int number_;
};

[[noreturn]] void failToRead(const fs::path& path, int error)
{
    const auto [reason, advice] = readObstacle(path, error);
    throw ReadFailure{false, reason, advice};
}

/// Follows symbolic links as far as the path exists, so that a path out of the case is refused
/// whether or not something lies there.
fs::path resolved(const fs::path& path)
{
    std::error_code failure;
    auto result = fs::weakly_canonical(path, failure);
    if (failure) failToRead(path, failure.value());
    return result;
}

bool isBeneath(const fs::path& path, const fs::path& root)
{
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

std::string readAll(const fs::path& path, int descriptor, std::uint64_t mostBytes)
{
    std::string bytes;
    std::string block(1 << 16, '\0');
    for (;;) {
        const auto count = read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) failToRead(path, errno);
        if (count == 0) return bytes;
        bytes.append(block, 0, static_cast<std::size_t>(count));
        if (bytes.size() > mostBytes)
            throw ReadFailure{true,
                              format("dictionaries are read up to {} MiB in all", mostBytes >> 20)};
    }
}

} // namespace

FileContent readConfined(const fs::path& file, const fs::path& root, std::uint64_t mostBytes)
{
    const auto home = resolved(root);
    const auto path = resolved(file);
    if (!isBeneath(path, home)) throw ReadFailure{true, "it leads out of the case"};

    const Descriptor descriptor(
        open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW | O_NOCTTY));
    if (descriptor.number() < 0) failToRead(path, errno);

    struct stat status {};
    if (fstat(descriptor.number(), &status) != 0) failToRead(path, errno);
    if (S_ISDIR(status.st_mode)) throw ReadFailure{true, "it is a folder", "name a file"};
    if (!S_ISREG(status.st_mode)) throw ReadFailure{true, "it is not a regular file"};
    return {readAll(path, descriptor.number(), mostBytes), path,
            path.lexically_relative(home).string(), status.st_dev, status.st_ino};
}

void normaliseText(std::string& text)
{
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());

    std::size_t kept = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool isPair = text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
        if (!isPair) text[kept++] = text[at] == '\r' ? '\n' : text[at];
    }
    text.resize(kept);
}

void requireText(const Source& source, std::uint16_t number)
{
    const auto refuse = [&](std::size_t at, const std::string& message) {
        throw Fault{Token{TokenKind::word, number, static_cast<std::uint32_t>(at), 1}, message,
                    "dictionaries are plain UTF-8 text"};
    };
    for (std::size_t at = 0; at < source.text.size();) {
        const auto length = characterLength(source.text, at);
        if (length == 0) refuse(at, "this byte is not UTF-8");
        if (source.text[at] == '\0') refuse(at, "there is a NUL byte in the text");
        at += length;
    }
}

} // namespace fpm
