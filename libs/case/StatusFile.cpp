#include "case/StatusFile.h"

#include "base/Hash.h"
#include "case/RunStatus.h"
#include "io/FileError.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>

namespace fpm {

namespace {

constexpr std::size_t step = 512, largest = 4096; ///< one block of a disk
constexpr std::string_view checksumKey = "checksum \"";
constexpr std::string_view checksumEnd = "\";\n";

std::string checksumLine(std::string_view text)
{
    return std::string(checksumKey) + hexText(hashOf(text)) + std::string(checksumEnd);
}

/// Size of a file that holds all of `text` and a little more.
std::size_t sizeFor(const std::string& text)
{
    const std::size_t needed = text.size() + checksumLine("").size() + 1;
    return std::min((needed / step + 1) * step, largest);
}

/// With its checksum, filled up with blanks to `size` bytes; lines that do not fit are left out.
std::string filled(std::string text, std::size_t size)
{
    const std::size_t most = size - checksumLine("").size() - 1;
    if (text.size() > most) text.resize(text.rfind('\n', most - 1) + 1);
    text += checksumLine(text);
    text.resize(size - 1, ' ');
    return text + '\n';
}

} // namespace

StatusFile::StatusFile(const OutputFolder& output, const std::string& text)
    : output_(output),
      size_(sizeFor(text))
{
    output_.write(statusFile, filled(text, size_));
    open();
}

void StatusFile::replace(const std::string& text)
{
    const std::size_t size = sizeFor(text);
    output_.renew(statusFile, filled(text, size));
    open();
    size_ = size;
}

void StatusFile::open()
{
    file_ = output_.open(statusFile, O_WRONLY);
    // Where blocks are smaller than what may be written; a file system that cannot does without.
    ::fallocate(file_.number(), FALLOC_FL_KEEP_SIZE, 0, largest);
}

bool StatusFile::isThere() const
{
    struct stat ours {
    }, there{};
    return ::fstat(file_.number(), &ours) == 0
           && ::lstat(output_.path(statusFile).c_str(), &there) == 0 && ours.st_dev == there.st_dev
           && ours.st_ino == there.st_ino;
}

void StatusFile::rewrite(const std::string& text, bool last)
{
    const auto fail = [&](int cause) { throw FileError("write", output_.path(statusFile), cause); };
    const bool gone = !isThere();
    if (gone || sizeFor(text) > size_) try {
            replace(text);
        } catch (const FileError&) {
            if (gone) throw;
        }
    const std::string content = filled(text, size_);
    // One that is cut short is written again as a whole: readers take it only with its checksum.
    ssize_t written = -1;
    for (int tries = 0; written != ssize_t(content.size()) && tries < 10; ++tries) {
        written = ::pwrite(file_.number(), content.data(), content.size(), 0);
        if (written < 0 && errno != EINTR) fail(errno);
    }
    if (written != ssize_t(content.size())) fail(ENOSPC);
    // A disk that does not keep it shows an earlier status after a loss of power; what is there now
    // is true, and no later word could be kept better.
    if (last) ::fdatasync(file_.number());
}

std::optional<std::string> statusText(const std::string& content)
{
    const auto at = content.rfind(checksumKey);
    if (at == content.npos || (at > 0 && content[at - 1] != '\n')) return content;
    const std::string text = content.substr(0, at), line = checksumLine(text);
    if (content.compare(at, line.size(), line) != 0) return std::nullopt;
    return text;
}

} // namespace fpm
