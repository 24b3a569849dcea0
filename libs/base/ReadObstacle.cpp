#include "base/ReadObstacle.h"

#include "base/Format.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace fpm {

namespace {

namespace fs = std::filesystem;

std::string nameOf(uid_t user)
{
    passwd entry{}, *found = nullptr;
    std::array<char, 4096> buffer;
    if (getpwuid_r(user, &entry, buffer.data(), buffer.size(), &found) == 0 && found != nullptr)
        return entry.pw_name;
    return format("user {}", user);
}

/// "drwxr-x---", as ls shows it.
std::string textOf(mode_t mode)
{
    std::string text = S_ISDIR(mode) ? "d" : "-";
    for (int bit = 8; bit >= 0; --bit) text += mode & (1u << bit) ? "xwr"[bit % 3] : '-';
    return text;
}

bool isAllowed(const fs::path& path, int access)
{
    return faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) == 0;
}

/// The first folder on the way that is closed to us, else the path itself.
fs::path closedPart(const fs::path& path)
{
    fs::path part;
    for (const fs::path& name : path) {
        part /= name;
        if (part != path && !isAllowed(part, X_OK)) return part;
    }
    return path;
}

} // namespace

ReadObstacle readObstacle(const fs::path& path, int error)
{
    std::error_code failure;
    if (error == EISDIR || (error == 0 && fs::is_directory(path, failure)))
        return {"it is a folder", "name a file in it"};
    if (error != EACCES) return {std::generic_category().message(error), ""};
    const fs::path closed = closedPart(fs::absolute(path, failure));
    struct stat status {};
    if (stat(closed.c_str(), &status) != 0) return {"permission denied", ""};
    const bool isOwn = status.st_uid == geteuid();
    const std::string command =
        format("chmod u+{} '{}'", S_ISDIR(status.st_mode) ? "rx" : "r", closed.string());
    return {format("permission denied: '{}' belongs to {}, {}", closed.string(),
                   nameOf(status.st_uid), textOf(status.st_mode)),
            isOwn ? command
                  : format("ask {} to make it readable, or for a copy that is yours",
                           nameOf(status.st_uid))};
}

} // namespace fpm
