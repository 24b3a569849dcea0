#include "io/OutputFolder.h"

#include "base/Format.h"
#include "io/FileError.h"
#include "io/WrittenBytes.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <optional>

namespace fpm {

namespace fs = std::filesystem;

struct OutputFolder::Shared {
    fs::path path; ///< for messages
    Descriptor folder;
    FullDiskPolicy policy;
};

/// A name in an open folder.
struct OutputFolder::Place {
    Descriptor folder;
    std::string name;
    fs::path path; ///< whole, for messages
};

/// What a file is to hold.
struct OutputFolder::Content {
    std::uint64_t size;
    std::function<void(const Descriptor& out, const fs::path& path)> fill;
    std::optional<mode_t> mode; ///< nothing: as that of the file there was
    bool waits;                 ///< for the disk
};

namespace {

constexpr int folderFlags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
constexpr mode_t permissions = 0777;

/// Names one after the other, none of which leads upwards or to another root.
fs::path checked(std::string_view relative)
{
    const auto refuse = [&](std::string_view reason) {
        throw Error(ExitCode::fileIo, format("path '{}' {}", relative, reason),
                    "paths in a case are relative to it and stay inside");
    };
    const fs::path path(relative);
    if (path.is_absolute()) refuse("is absolute");
    if (relative.find('\0') != relative.npos) refuse("holds a zero byte");
    if (std::ranges::find(path, "..") != path.end()) refuse("leads upwards");
    return path;
}

[[noreturn]] void refuseLink(const fs::path& path)
{
    throw FileError(format("'{}' is a link: nothing is written through it", path.string()),
                    "remove the link; for results on another disk put the whole case there, or "
                    "mount the disk at this folder",
                    path);
}

/// What is in the way where a folder or a file cannot be opened.
[[noreturn]] void
refuseEntry(const Descriptor& folder, const std::string& name, const fs::path& path, int cause)
{
    struct stat status {};
    const bool isThere =
        ::fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
    if (isThere && S_ISLNK(status.st_mode)) refuseLink(path);
    if (isThere && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))
        throw FileError(format("'{}' is neither a file nor a folder", path.string()),
                        "remove or rename it", path);
    throw FileError("open", path, cause);
}

void synchroniseFolder(const Descriptor& folder, const fs::path& path)
{
    // Some network file systems have no fsync for folders (EINVAL); there the rename is all there
    // is.
    if (::fsync(folder.number()) != 0 && errno != EINVAL && errno != EINTR)
        throw FileError("write the folder", path, errno);
}

/// Removes the temporary file unless it was renamed.
struct Temporary {
    const Descriptor& folder;
    std::string name;
    bool renamed = false;
    ~Temporary()
    {
        if (!renamed) ::unlinkat(folder.number(), name.c_str(), 0);
    }
};

std::optional<mode_t> modeOf(const Descriptor& folder, const std::string& name)
{
    struct stat status {};
    if (::fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0
        || !S_ISREG(status.st_mode))
        return std::nullopt;
    return status.st_mode & permissions;
}

} // namespace

OutputFolder::OutputFolder(const fs::path& folder, FullDiskPolicy policy)
{
    Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened.isOpen()) throw FileError("open the folder", folder, errno);
    shared_ = std::make_shared<const Shared>(Shared{folder, std::move(opened), std::move(policy)});
}

OutputFolder OutputFolder::make(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError("create the folder", folder, error.value());
    return OutputFolder(folder);
}

fs::path OutputFolder::path(std::string_view relative) const
{
    return relative.empty() ? shared_->path : shared_->path / relative;
}

const FullDiskPolicy& OutputFolder::fullDisk() const
{
    return shared_->policy;
}

/// One name after the other, each from the folder before: what openat2 does with RESOLVE_BENEATH
/// and RESOLVE_NO_SYMLINKS, on every kernel, and it knows which name is the link.
Descriptor OutputFolder::walk(const fs::path& folder, Missing missing) const
{
    Descriptor at(::fcntl(shared_->folder.number(), F_DUPFD_CLOEXEC, 0));
    if (!at.isOpen()) throw FileError("open the folder", shared_->path, errno);
    fs::path path = shared_->path;
    for (const fs::path& part : folder) {
        if (part.empty() || part == ".") continue;
        path /= part;
        Descriptor next(::openat(at.number(), part.c_str(), folderFlags));
        if (!next.isOpen() && errno == ENOENT && missing == Missing::create) {
            if (::mkdirat(at.number(), part.c_str(), permissions) != 0 && errno != EEXIST)
                throw FileError("create the folder", path, errno);
            synchroniseFolder(at, path);
            next = Descriptor(::openat(at.number(), part.c_str(), folderFlags));
        }
        if (!next.isOpen()) refuseEntry(at, part.string(), path, errno);
        at = std::move(next);
    }
    return at;
}

OutputFolder::Place OutputFolder::placeOf(std::string_view relative, Missing missing) const
{
    const fs::path path = checked(relative);
    const std::string name = path.filename().string();
    if (name.empty() || name == ".")
        throw Error(ExitCode::fileIo, format("path '{}' names no file", relative),
                    "paths in a case are relative to it and stay inside");
    return {walk(path.parent_path(), missing), name, this->path(relative)};
}

void OutputFolder::replace(std::string_view file, const Content& content) const
{
    const Place place = placeOf(file, Missing::create);
    const int folder = place.folder.number();
    Temporary temporary{place.folder, format(".{}.{}.tmp", place.name, ::getpid())};
    const char* name = temporary.name.c_str();
    // A leftover of a process that had the same number; O_EXCL then never follows a link.
    ::unlinkat(folder, name, 0);
    Descriptor out(::openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!out.isOpen()) throw FileError("create", place.path, errno);
    reserve(out, content.size, place.path);
    content.fill(out, place.path);
    const auto mode = content.mode ? content.mode : modeOf(place.folder, place.name);
    if (mode && ::fchmod(out.number(), *mode) != 0)
        throw FileError("set the permissions of", place.path, errno);
    if (content.waits) synchronise(out, place.path);
    if (const int code = out.close()) throw FileError("close", place.path, code);
    if (::renameat(folder, name, folder, place.name.c_str()) != 0)
        throw FileError("replace", place.path, errno);
    temporary.renamed = true;
    if (content.waits) synchroniseFolder(place.folder, place.path.parent_path());
}

void OutputFolder::write(std::string_view file, std::span<const std::byte> bytes) const
{
    const auto fill = [&](const Descriptor& out, const fs::path& path) {
        writeAll(out, bytes, path);
    };
    fullDisk().attempt(path(file), [&] { replace(file, {bytes.size(), fill, {}, true}); });
}

void OutputFolder::write(std::string_view file, std::string_view text) const
{
    write(file, std::as_bytes(std::span(text)));
}

void OutputFolder::renew(std::string_view file, std::string_view text) const
{
    const auto fill = [&](const Descriptor& out, const fs::path& path) {
        writeAll(out, std::as_bytes(std::span(text)), path);
    };
    replace(file, {text.size(), fill, {}, false});
}

void OutputFolder::copy(const fs::path& from, std::string_view file) const
{
    fullDisk().attempt(path(file), [&] {
        const Descriptor in(::open(from.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
        struct stat status {};
        if (!in.isOpen() || ::fstat(in.number(), &status) != 0)
            throw FileError("read", from, errno);
        if (!S_ISREG(status.st_mode))
            throw FileError(format("'{}' is not a regular file", from.string()), "", from);
        const auto fill = [&](const Descriptor& out, const fs::path& path) {
            copyAll(in, from, out, path);
        };
        replace(file, {std::uint64_t(status.st_size), fill, status.st_mode & permissions, false});
    });
}

Descriptor OutputFolder::open(std::string_view file, int flags) const
{
    Descriptor opened;
    fullDisk().attempt(path(file), [&] { opened = openOnce(file, flags); });
    return opened;
}

Descriptor OutputFolder::openOnce(std::string_view file, int flags) const
{
    const Place place = placeOf(file, flags & O_CREAT ? Missing::create : Missing::refuse);
    Descriptor opened(::openat(place.folder.number(), place.name.c_str(),
                               flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666));
    if (!opened.isOpen()) refuseEntry(place.folder, place.name, place.path, errno);
    struct stat status {};
    if (::fstat(opened.number(), &status) != 0) throw FileError("open", place.path, errno);
    if (!S_ISREG(status.st_mode))
        throw FileError(format("'{}' is not a regular file", place.path.string()),
                        "remove or rename it", place.path);
    if (status.st_nlink != 1)
        throw FileError(format("'{}' has {} names (hard links): what is written into it would show "
                               "in the others",
                               place.path.string(), status.st_nlink),
                        "remove or rename it", place.path);
    return opened;
}

Descriptor OutputFolder::openFolder(std::string_view folder) const
{
    return walk(checked(folder), Missing::refuse);
}

OutputFolder OutputFolder::inner(std::string_view folder) const
{
    Descriptor opened;
    fullDisk().attempt(path(folder), [&] { opened = walk(checked(folder), Missing::create); });
    return OutputFolder(
        std::make_shared<const Shared>(Shared{path(folder), std::move(opened), fullDisk()}));
}

void OutputFolder::synchroniseNames(std::string_view folder) const
{
    fullDisk().attempt(path(folder), [&] { synchroniseFolder(openFolder(folder), path(folder)); });
}

void OutputFolder::rename(std::string_view from, std::string_view to) const
{
    fullDisk().attempt(path(to), [&] {
        const Place old = placeOf(from, Missing::refuse), place = placeOf(to, Missing::create);
        if (::renameat(old.folder.number(), old.name.c_str(), place.folder.number(),
                       place.name.c_str())
            != 0)
            throw FileError(format("rename '{}' to", from), place.path, errno);
    });
}

bool OutputFolder::link(std::string_view file, std::string_view name) const
{
    bool isMade = false;
    fullDisk().attempt(path(name), [&] {
        const Place old = placeOf(file, Missing::refuse), place = placeOf(name, Missing::create);
        isMade = ::linkat(old.folder.number(), old.name.c_str(), place.folder.number(),
                          place.name.c_str(), 0)
                 == 0;
        const bool cannot =
            errno == EPERM || errno == EXDEV || errno == EMLINK || errno == EOPNOTSUPP;
        if (!isMade && !cannot) throw FileError(format("link '{}' to", file), place.path, errno);
    });
    return isMade;
}

bool OutputFolder::remove(std::string_view name) const
{
    const Place place = placeOf(name, Missing::refuse);
    const int folder = place.folder.number();
    if (::unlinkat(folder, place.name.c_str(), 0) == 0) return true;
    if (errno == ENOENT) return false;
    // Linux says EISDIR of a folder, POSIX EPERM.
    const int cause = errno;
    if ((cause == EISDIR || cause == EPERM)
        && ::unlinkat(folder, place.name.c_str(), AT_REMOVEDIR) == 0)
        return true;
    if (errno == ENOTEMPTY || errno == EEXIST) return false;
    throw FileError("remove", place.path, errno == ENOTDIR ? cause : errno);
}

} // namespace fpm
