#include "base/ChildProcess.h"
#include "base/Error.h"
#include "base/Format.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <string_view>

namespace fpm {

namespace {

constexpr char goodAnswer = 'g', errorAnswer = 'e';

void limit(int resource, std::uint64_t most)
{
    const rlimit bounds{most, most};
    setrlimit(resource, &bounds);
}

/// Bytes of address space this process has now.
std::uint64_t addressSpace()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * std::uint64_t(sysconf(_SC_PAGESIZE));
}

/// False when the reader is gone.
bool sendAll(int pipe, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t sent = write(pipe, bytes.data(), bytes.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes.remove_prefix(std::size_t(sent));
    }
    return true;
}

std::string receiveAll(int pipe)
{
    std::string bytes;
    std::array<char, 1 << 16> buffer;
    for (;;) {
        const ssize_t count = read(pipe, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return bytes;
        bytes.append(buffer.data(), std::size_t(count));
    }
}

/// First byte: kind; for an error the second: exit code; then the result or the message.
std::string answerOf(const ChildTask& task, const std::function<std::string()>& work)
{
    const auto failure = [](ExitCode code, const std::string& text, const std::string& advice) {
        return std::string{errorAnswer, char(code)} + text + '\0' + advice;
    };
    try {
        return goodAnswer + work();
    } catch (const Error& error) {
        return failure(error.code(), error.what(), error.advice());
    } catch (const std::bad_alloc&) {
        return failure(task.code,
                       task.subject + ": rejected, it takes more memory than its size allows for",
                       task.advice);
    } catch (const std::exception& error) {
        return failure(task.code, task.subject + ": rejected, " + error.what(), task.advice);
    }
}

[[noreturn]] void
runChild(int pipe, const ChildTask& task, const std::function<std::string()>& work)
{
    // Nothing of the parent may be written twice, and a dying library should not speak.
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    for (const int caught : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU})
        std::signal(caught, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    if (task.memoryBytes > 0) limit(RLIMIT_AS, addressSpace() + task.memoryBytes);
    if (task.cpuSeconds > 0) limit(RLIMIT_CPU, task.cpuSeconds);
    const std::string answer = answerOf(task, work);
    _exit(sendAll(pipe, answer) ? 0 : 1);
}

std::string deathOf(const ProcessEnd& end)
{
    if (end.signal == SIGXCPU || end.signal == SIGKILL)
        return "the reader took too much time or memory";
    if (end.signal != 0) return format("the reader died of signal {}", end.signal);
    return format("the reader left with status {}", end.exitCode);
}

} // namespace

std::string inChild(const ChildTask& task, const std::function<std::string()>& work)
{
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(ExitCode::fileIo,
                    format("{}: no pipe: {}", task.subject, std::strerror(errno)));
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        runChild(ends[1], task, work);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        throw Error(ExitCode::memory,
                    format("{}: no process: {}", task.subject, std::strerror(errno)));
    }
    std::string answer = receiveAll(ends[0]);
    close(ends[0]);
    const ProcessEnd left = reaped(child);
    if (!left.succeeded() || answer.empty())
        throw Error(task.code, format("{}: rejected, {}", task.subject, deathOf(left)),
                    task.advice);
    if (answer[0] == errorAnswer && answer.size() > 1) {
        const auto end = answer.find('\0', 2); // between message and advice
        const auto advice = end == std::string::npos ? "" : answer.substr(end + 1);
        throw Error(ExitCode(int(answer[1])), answer.substr(2, end - 2), advice);
    }
    return answer.substr(1);
}

} // namespace fpm
