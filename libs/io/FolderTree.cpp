#include "io/FolderTree.h"

#include "base/Format.h"
#include "io/FileError.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <charconv>
#include <csignal>
#include <vector>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// Names in an open folder.
std::vector<std::string> namesIn(const Descriptor& folder, const fs::path& path)
{
    // The stream owns a descriptor of its own, and with it a position.
    Descriptor again(::openat(folder.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    DIR* stream = again.isOpen() ? ::fdopendir(again.number()) : nullptr;
    if (stream == nullptr) throw FileError("read the folder", path, errno);
    again.release();
    std::vector<std::string> names;
    while (const dirent* entry = ::readdir(stream)) {
        const std::string_view name = entry->d_name;
        if (name != "." && name != "..") names.emplace_back(name);
    }
    ::closedir(stream);
    return names;
}

/// Whether another disk, or another folder, is mounted at this name.
bool isMounted(const Descriptor& folder, const std::string& name)
{
    struct statx here {
    }, there{};
    constexpr int flags = AT_SYMLINK_NOFOLLOW | AT_NO_AUTOMOUNT;
    if (::statx(folder.number(), name.c_str(), flags, STATX_TYPE, &there) != 0) return false;
    if (there.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT)
        return there.stx_attributes & STATX_ATTR_MOUNT_ROOT;
    // Linux before 5.8
    if (::statx(folder.number(), "", AT_EMPTY_PATH, STATX_TYPE, &here) != 0) return false;
    return here.stx_dev_major != there.stx_dev_major || here.stx_dev_minor != there.stx_dev_minor;
}

void removeFolder(const Descriptor& above, const std::string& name, const fs::path& path);

void removeEntry(const Descriptor& folder, const std::string& name, const fs::path& path)
{
    if (::unlinkat(folder.number(), name.c_str(), 0) == 0 || errno == ENOENT) return;
    if (errno != EISDIR && errno != EPERM) throw FileError("remove", path, errno);
    removeFolder(folder, name, path);
}

void removeFolder(const Descriptor& above, const std::string& name, const fs::path& path)
{
    if (isMounted(above, name))
        throw FileError(
            format("'{}' is another disk, mounted there: it is not removed", path.string()),
            "unmount it first", path);
    const Descriptor folder(
        ::openat(above.number(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!folder.isOpen()) throw FileError("remove", path, errno);
    for (const std::string& inner : namesIn(folder, path)) removeEntry(folder, inner, path / inner);
    if (::unlinkat(above.number(), name.c_str(), AT_REMOVEDIR) != 0 && errno != ENOENT)
        throw FileError("remove", path, errno);
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

bool isRegularFile(const Descriptor& folder, const std::string& name)
{
    struct stat status {};
    return ::fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0
           && S_ISREG(status.st_mode);
}

} // namespace

void removeTree(const OutputFolder& output, std::string_view folder)
{
    const fs::path path = output.path(folder), relative(folder);
    const std::string name = relative.filename().string();
    if (name.empty() || name == ".")
        throw Error(ExitCode::internal, format("'{}' names no folder to remove", folder));
    std::error_code error;
    if (!fs::exists(fs::symlink_status(path, error))) return;
    output.openFolder(folder); // refuses links and ".."
    removeFolder(output.openFolder(relative.parent_path().string()), name, path);
}

int removeTemporaries(const OutputFolder& output, std::string_view folder, bool deadOnly)
{
    int count = 0;
    try {
        const Descriptor opened = output.openFolder(folder);
        for (const std::string& name : namesIn(opened, output.path(folder))) {
            const pid_t process = writerOf(name);
            if (process <= 0 || !isRegularFile(opened, name)) continue;
            const bool isAlive =
                process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH);
            if (deadOnly && isAlive) continue;
            count += ::unlinkat(opened.number(), name.c_str(), 0) == 0;
        }
    } catch (const FileError&) {
        // What cannot be read does not stop who only tidies up.
    }
    return count;
}

} // namespace fpm
