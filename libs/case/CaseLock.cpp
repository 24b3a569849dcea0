#include "case/CaseLock.h"

#include "base/Error.h"
#include "base/Format.h"
#include "base/Machine.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace fpm {

namespace {

constexpr const char* nobodyKnown = "another process";

/// What the holder wrote about itself; a stranger's file is not printed as it is.
std::string holder(int descriptor)
{
    std::string text(200, '\0');
    const auto count = pread(descriptor, text.data(), text.size(), 0);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    text.resize(std::min(text.find('\n'), text.size()));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.empty() ? nobodyKnown : text;
}

/// 0, or the error. Locks belong to the open file (not the process) where the system supports it.
int lockWhole(int descriptor)
{
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (fcntl(descriptor, F_OFD_SETLK, &whole) == 0) return 0;
    if (errno != EINVAL) return errno == EACCES ? EAGAIN : errno;
    return flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}

/// Whether another process holds the lock: tests it without taking it, where the system can.
bool isLocked(int descriptor)
{
    struct flock whole {};
    whole.l_type = F_RDLCK;
    whole.l_whence = SEEK_SET;
    if (fcntl(descriptor, F_OFD_GETLK, &whole) == 0) return whole.l_type != F_UNLCK;
    if (errno != EINVAL) return true;
    if (flock(descriptor, LOCK_SH | LOCK_NB) != 0) return true;
    flock(descriptor, LOCK_UN);
    return false;
}

std::string nameOfHolder(int process, const std::string& host)
{
    return format("process {} on {}", process, host);
}

/// A link would have us write elsewhere.
bool isOwnFile(int descriptor)
{
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1;
}

void describeHolder(int descriptor, const std::string& application)
{
    const auto text = format("{}, {}, since {}\n", application,
                             nameOfHolder(processNumber(), hostName()), utcDate());
    // The lock holds without this text, so a full disk is no reason to stop.
    if (ftruncate(descriptor, 0) != 0) return;
    [[maybe_unused]] const auto written = pwrite(descriptor, text.data(), text.size(), 0);
}

} // namespace

CaseLock::CaseLock(const std::filesystem::path& caseRoot, const std::string& application)
    : descriptor_(open(
        (caseRoot / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666))
{
    const auto refuse = [&](ExitCode code, const std::string& message, const std::string& advice) {
        if (descriptor_ >= 0) close(descriptor_);
        throw Error(code, message, advice);
    };
    const auto reason = [](int error) { return std::generic_category().message(error); };
    const auto folder = caseRoot.string();
    if (descriptor_ < 0)
        refuse(ExitCode::fileIo, format("cannot write in case {}: {}", folder, reason(errno)),
               "check the permissions of the folder and of its file .lock");
    if (!isOwnFile(descriptor_))
        refuse(ExitCode::fileIo, format("{}/.lock is a link or no regular file", folder),
               "delete it");

    const int error = lockWhole(descriptor_);
    if (error == EAGAIN)
        refuse(ExitCode::caseLocked, format("case {} is in use by {}", folder, holder(descriptor_)),
               "wait for it to end, or work in a copy of the case");
    if (error != 0)
        refuse(ExitCode::caseLocked, format("cannot lock case {}: {}", folder, reason(error)),
               "the file system must support locks; work on a local disk");
    describeHolder(descriptor_, application);
}

CaseLock::~CaseLock()
{
    close(descriptor_);
}

bool holdsCase(const std::filesystem::path& caseRoot, int process, const std::string& host)
{
    const int descriptor =
        open((caseRoot / ".lock").c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return errno != ENOENT && errno != ELOOP;
    const bool locked = isLocked(descriptor);
    const std::string name = holder(descriptor);
    close(descriptor);
    return locked
           && (name == nobodyKnown || name.find(nameOfHolder(process, host) + ",") != name.npos);
}

} // namespace fpm
