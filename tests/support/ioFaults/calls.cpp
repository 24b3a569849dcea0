// Stands before the C library (LD_PRELOAD) and makes calls that change files fail; see README.md.
#include "Fault.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>

using namespace ioFaults;

namespace {

template <class Function>
Function next(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool fails(const char* call, const std::string& path)
{
    return fateOf(call, path) == Fate::fail;
}

bool changes(std::uint64_t flags)
{
    return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE;
}

/// Of a call that takes `size` bytes: how many to pass on; -1: it fails.
ssize_t granted(const char* call, int file, std::size_t size, bool& thenDies)
{
    const Fate fate = fateOf(call, pathOf(file));
    thenDies = fate == Fate::tear;
    if (fate == Fate::fail) return -1;
    return ssize_t(fate == Fate::pass ? size : (size + 1) / 2);
}

long openFile(int folder, const char* path, int flags, unsigned mode)
{
    if (changes(std::uint64_t(flags)) && fails("open", pathAt(folder, path))) return -1;
    return systemCall(SYS_openat, folder, long(path), flags, mode);
}

/// The mode stands behind the flags where a file may be made.
unsigned modeOf(int flags, std::va_list rest)
{
    return (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(rest, unsigned) : 0;
}

std::FILE* openStream(const char* name, const char* path, const char* mode)
{
    if (std::strpbrk(mode, "wa+") && fails("open", pathAt(AT_FDCWD, path))) return nullptr;
    return next<std::FILE* (*)(const char*, const char*)>(name)(path, mode);
}

int reserved(const char* name, int file, off_t from, off_t size)
{
    if (fails("posix_fallocate", pathOf(file))) return errno;
    return next<int (*)(int, off_t, off_t)>(name)(file, from, size);
}

int cut(int file, off_t size)
{
    return fails("ftruncate", pathOf(file)) ? -1 : int(systemCall(SYS_ftruncate, file, size));
}

int renamed(int oldFolder, const char* from, int newFolder, const char* to, unsigned flags)
{
    if (fails("rename", pathAt(newFolder, to))) return -1;
    return int(systemCall(SYS_renameat2, oldFolder, long(from), newFolder, long(to), flags));
}

int removed(int folder, const char* path, int flags)
{
    if (fails("unlink", pathAt(folder, path))) return -1;
    return int(systemCall(SYS_unlinkat, folder, long(path), flags));
}

ssize_t vectors(const char* call, int file, const iovec* parts, int count)
{
    std::size_t size = 0;
    for (int i = 0; i < count; ++i) size += parts[i].iov_len;
    bool dies = false;
    const ssize_t allowed = granted(call, file, size, dies);
    if (allowed < 0) return -1;
    if (std::size_t(allowed) == size && !dies)
        return systemCall(SYS_writev, file, long(parts), count);
    const std::size_t first = std::min(std::size_t(allowed), parts[0].iov_len);
    const ssize_t done = systemCall(SYS_write, file, long(parts[0].iov_base), long(first));
    if (dies) killProcess();
    return done;
}

} // namespace

extern "C" {

ssize_t write(int file, const void* bytes, std::size_t size)
{
    bool dies = false;
    const ssize_t allowed = granted("write", file, size, dies);
    if (allowed < 0) return -1;
    const long done = systemCall(SYS_write, file, long(bytes), allowed);
    if (dies) killProcess();
    return done;
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t at)
{
    bool dies = false;
    const ssize_t allowed = granted("pwrite", file, size, dies);
    if (allowed < 0) return -1;
    const long done = systemCall(SYS_pwrite64, file, long(bytes), allowed, at);
    if (dies) killProcess();
    return done;
}

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off_t at)
{
    return pwrite(file, bytes, size, at);
}

ssize_t writev(int file, const iovec* parts, int count)
{
    return vectors("write", file, parts, count);
}

int fsync(int file)
{
    return fails("fsync", pathOf(file)) ? -1 : int(systemCall(SYS_fsync, file));
}

int fdatasync(int file)
{
    return fails("fdatasync", pathOf(file)) ? -1 : int(systemCall(SYS_fdatasync, file));
}

/// A close that reports an error has closed, as on Linux.
int close(int file)
{
    const bool reports = isWritten(file) && fails("close", pathOf(file));
    const int error = errno;
    const int done = int(systemCall(SYS_close, file));
    if (!reports) return done;
    errno = error;
    return -1;
}

int open(const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const unsigned mode = modeOf(flags, rest);
    va_end(rest);
    return int(openFile(AT_FDCWD, path, flags, mode));
}

int open64(const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const unsigned mode = modeOf(flags, rest);
    va_end(rest);
    return int(openFile(AT_FDCWD, path, flags, mode));
}

int openat(int folder, const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const unsigned mode = modeOf(flags, rest);
    va_end(rest);
    return int(openFile(folder, path, flags, mode));
}

int openat64(int folder, const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const unsigned mode = modeOf(flags, rest);
    va_end(rest);
    return int(openFile(folder, path, flags, mode));
}

std::FILE* fopen(const char* path, const char* mode)
{
    return openStream("fopen", path, mode);
}

std::FILE* fopen64(const char* path, const char* mode)
{
    return openStream("fopen64", path, mode);
}

int fclose(std::FILE* stream)
{
    const int file = fileno(stream);
    const bool reports = file >= 0 && isWritten(file) && fails("close", pathOf(file));
    const int error = errno;
    const int done = next<int (*)(std::FILE*)>("fclose")(stream);
    if (!reports) return done;
    errno = error;
    return EOF;
}

/// What a stream holds back is written here, past our write.
int fflush(std::FILE* stream)
{
    const int file = stream ? fileno(stream) : -1;
    if (file >= 0 && fails("fflush", pathOf(file))) return EOF;
    return next<int (*)(std::FILE*)>("fflush")(stream);
}

int posix_fallocate(int file, off_t from, off_t size)
{
    return reserved("posix_fallocate", file, from, size);
}

int posix_fallocate64(int file, off_t from, off_t size)
{
    return reserved("posix_fallocate64", file, from, size);
}

int ftruncate(int file, off_t size) noexcept
{
    return cut(file, size);
}

int ftruncate64(int file, off_t size) noexcept
{
    return cut(file, size);
}

int truncate(const char* path, off_t size) noexcept
{
    if (fails("ftruncate", pathAt(AT_FDCWD, path))) return -1;
    return int(systemCall(SYS_truncate, long(path), size));
}

int rename(const char* from, const char* to) noexcept
{
    return renamed(AT_FDCWD, from, AT_FDCWD, to, 0);
}

int renameat(int oldFolder, const char* from, int newFolder, const char* to) noexcept
{
    return renamed(oldFolder, from, newFolder, to, 0);
}

int renameat2(
    int oldFolder, const char* from, int newFolder, const char* to, unsigned flags) noexcept
{
    return renamed(oldFolder, from, newFolder, to, flags);
}

int unlink(const char* path) noexcept
{
    return removed(AT_FDCWD, path, 0);
}

int unlinkat(int folder, const char* path, int flags) noexcept
{
    return removed(folder, path, flags);
}

int rmdir(const char* path) noexcept
{
    return removed(AT_FDCWD, path, AT_REMOVEDIR);
}

int remove(const char* path) noexcept
{
    if (fails("unlink", pathAt(AT_FDCWD, path))) return -1;
    return next<int (*)(const char*)>("remove")(path);
}

int mkdir(const char* path, mode_t mode) noexcept
{
    if (fails("mkdir", pathAt(AT_FDCWD, path))) return -1;
    return int(systemCall(SYS_mkdir, long(path), mode));
}

int mkdirat(int folder, const char* path, mode_t mode) noexcept
{
    if (fails("mkdir", pathAt(folder, path))) return -1;
    return int(systemCall(SYS_mkdirat, folder, long(path), mode));
}

int link(const char* from, const char* to) noexcept
{
    if (fails("link", pathAt(AT_FDCWD, to))) return -1;
    return int(systemCall(SYS_linkat, AT_FDCWD, long(from), AT_FDCWD, long(to), 0));
}

int linkat(int oldFolder, const char* from, int newFolder, const char* to, int flags) noexcept
{
    if (fails("link", pathAt(newFolder, to))) return -1;
    return int(systemCall(SYS_linkat, oldFolder, long(from), newFolder, long(to), flags));
}

/// What the C library has no function for.
long syscall(long number, ...) noexcept
{
    std::va_list rest;
    va_start(rest, number);
    long a[6];
    for (long& argument : a) argument = va_arg(rest, long);
    va_end(rest);
    if (number == SYS_openat2) {
        const auto* how = reinterpret_cast<const open_how*>(a[2]);
        const auto* path = reinterpret_cast<const char*>(a[1]);
        if (changes(how->flags) && fails("open", pathAt(int(a[0]), path))) return -1;
    }
    if (number == SYS_renameat2)
        return renamed(int(a[0]), reinterpret_cast<const char*>(a[1]), int(a[2]),
                       reinterpret_cast<const char*>(a[3]), unsigned(a[4]));
    return systemCall(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

} // extern "C"
