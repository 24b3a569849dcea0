#include "Fault.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <string_view>

namespace ioFaults {
namespace {

struct Settings {
    std::string root, log;
    std::string_view kind;
    long at = 0;
    bool lasts = false;
};

const char* text(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

const Settings& settings()
{
    static const Settings read{text("FAULT_ROOT"), text("FAULT_LOG"), text("FAULT_KIND"),
                               std::atol(text("FAULT_AT")), *text("FAULT_LASTS") != '\0'};
    return read;
}

int errorOf(std::string_view kind)
{
    if (kind == "ENOSPC") return ENOSPC;
    if (kind == "EDQUOT") return EDQUOT;
    if (kind == "EINTR") return EINTR;
    return EIO;
}

/// One line a call: number, call, path in the folder. Opened for every line, so that it holds no
/// descriptor of the program.
void note(long number, const char* call, std::string_view path)
{
    if (settings().log.empty()) return;
    const std::string line = std::to_string(number) + " " + call + " " + std::string(path) + "\n";
    const long file = systemCall(SYS_openat, AT_FDCWD, long(settings().log.c_str()),
                                 O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) return;
    systemCall(SYS_write, file, long(line.data()), long(line.size()));
    systemCall(SYS_close, file);
}

std::string linkTarget(const std::string& link)
{
    char target[PATH_MAX];
    const long size =
        systemCall(SYS_readlinkat, AT_FDCWD, long(link.c_str()), long(target), sizeof target);
    return size > 0 ? std::string(target, std::size_t(size)) : "";
}

} // namespace

long systemCall(long number, long a, long b, long c, long d, long e, long f)
{
    using Call = long (*)(long, ...);
    static const auto call = reinterpret_cast<Call>(dlsym(RTLD_NEXT, "syscall"));
    return call(number, a, b, c, d, e, f);
}

void killProcess()
{
    systemCall(SYS_kill, systemCall(SYS_getpid), SIGKILL);
    for (;;) systemCall(SYS_pause);
}

std::string pathOf(int descriptor)
{
    const int before = errno;
    const std::string path = linkTarget("/proc/self/fd/" + std::to_string(descriptor));
    errno = before;
    return path;
}

std::string pathAt(int folder, const char* path)
{
    if (!path) return "";
    if (*path == '/') return path;
    const std::string base = folder == AT_FDCWD ? linkTarget("/proc/self/cwd") : pathOf(folder);
    return base.empty() ? "" : base + "/" + path;
}

bool isWritten(int descriptor)
{
    const int before = errno;
    const long flags = systemCall(SYS_fcntl, descriptor, F_GETFL);
    errno = before;
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

Fate fateOf(const char* call, const std::string& path)
{
    static std::atomic<long> counted{0};
    const std::string& root = settings().root;
    if (root.empty() || !path.starts_with(root)) return Fate::pass;
    const std::string_view rest = std::string_view(path).substr(root.size());
    if (!rest.empty() && rest.front() != '/') return Fate::pass;

    const long number = ++counted;
    const int before = errno;
    note(number, call, rest.empty() ? "." : rest.substr(1));
    errno = before;
    const bool meant = settings().at > 0
                       && (number == settings().at || (settings().lasts && number > settings().at));
    if (!meant) return Fate::pass;
    if (settings().kind == "kill") killProcess();
    if (settings().kind == "short") return Fate::shorten;
    if (settings().kind == "tear") return Fate::tear;
    errno = errorOf(settings().kind);
    return Fate::fail;
}

} // namespace ioFaults
