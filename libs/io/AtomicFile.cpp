#include "io/AtomicFile.h"

#include "base/Error.h"
#include "base/Format.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <string>
#include <system_error>
#include <utility>

namespace fpm {
namespace {

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& file, int code)
{
    throw Error(ExitCode::fileIo,
                "cannot " + action + " '" + file.string()
                    + "': " + std::generic_category().message(code),
                "check free space, quota and permissions; what was there before is untouched");
}

/// Closes on leaving; close() itself reports, because a full disk may only show there.
class Descriptor
{
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }
    /// Zero, or the error. On Linux the descriptor is gone in either case.
    int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

private:
    int number_;
};

/// Removes the temporary file unless it was renamed.
struct Temporary {
    std::filesystem::path path;
    bool renamed = false;
    ~Temporary()
    {
        if (!renamed) ::unlink(path.c_str());
    }
};

void writeAll(const Descriptor& out,
              std::span<const std::byte> bytes,
              const std::filesystem::path& file)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(out.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write", file, errno);
        if (written == 0) fail("write", file, ENOSPC);
        bytes = bytes.subspan(std::size_t(written));
    }
}

/// Reserves the space first, so that a full disk is found before anything is written. File systems
/// that cannot reserve say so, and the write loop finds out.
void reserve(const Descriptor& out, std::size_t size, const std::filesystem::path& file)
{
    if (size == 0) return;
    int code = EINTR;
    while (code == EINTR) code = ::posix_fallocate(out.number(), 0, off_t(size));
    if (code == ENOSPC || code == EDQUOT || code == EFBIG || code == EIO) fail("write", file, code);
}

void synchronise(const Descriptor& descriptor, const std::filesystem::path& file)
{
    int result = ::fsync(descriptor.number());
    while (result != 0 && errno == EINTR) result = ::fsync(descriptor.number());
    if (result != 0) fail("write", file, errno);
}

void synchroniseFolder(const std::filesystem::path& folder)
{
    Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.number() < 0) fail("open the folder", folder, errno);
    // Some network file systems have no fsync for folders (EINVAL); there the rename is all there
    // is.
    if (::fsync(directory.number()) != 0 && errno != EINVAL && errno != EINTR)
        fail("write the folder", folder, errno);
    if (const int code = directory.close()) fail("close the folder", folder, code);
}

enum class Waits { yes, no };

void write(const std::filesystem::path& file, std::span<const std::byte> bytes, Waits waits)
{
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail("create the folder", folder, error.value());

    const std::filesystem::path path =
        folder / format(".{}.{}.tmp", file.filename().string(), ::getpid());
    // A leftover of a process that had the same number; O_EXCL then never follows a link.
    ::unlink(path.c_str());
    Descriptor out(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.number() < 0) fail("create", path, errno);
    Temporary temporary{path};
    reserve(out, bytes.size(), file);
    writeAll(out, bytes, file);
    if (waits == Waits::yes) synchronise(out, file);
    if (const int code = out.close()) fail("close", file, code);
    if (::rename(path.c_str(), file.c_str()) != 0) fail("replace", file, errno);
    temporary.renamed = true;
    if (waits == Waits::yes) synchroniseFolder(folder);
}

/// The process in the name of a temporary file, ".<file>.<process>.tmp"; 0 for any other name.
pid_t writerOf(std::string_view name)
{
    constexpr std::string_view ending = ".tmp";
    if (!name.starts_with('.') || !name.ends_with(ending)) return 0;
    name.remove_suffix(ending.size());
    const auto dot = name.rfind('.');
    if (dot < 2) return 0;
    pid_t process = 0;
    const auto [end, error] =
        std::from_chars(name.data() + dot + 1, name.data() + name.size(), process);
    return error == std::errc() && end == name.data() + name.size() ? process : 0;
}

} // namespace

void writeFileAtomically(const std::filesystem::path& file, std::span<const std::byte> bytes)
{
    write(file, bytes, Waits::yes);
}

void writeFileAtomically(const std::filesystem::path& file, std::string_view text)
{
    writeFileAtomically(file, std::as_bytes(std::span(text)));
}

void renewFile(const std::filesystem::path& file, std::string_view text)
{
    write(file, std::as_bytes(std::span(text)), Waits::no);
}

int removeTemporaries(const std::filesystem::path& folder, bool deadOnly)
{
    int count = 0;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const pid_t process = writerOf(entry.path().filename().string());
        if (process <= 0 || !entry.is_regular_file(error) || entry.is_symlink(error)) continue;
        const bool isAlive = process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH);
        if (deadOnly && isAlive) continue;
        count += std::filesystem::remove(entry.path(), error);
    }
    return count;
}

} // namespace fpm
