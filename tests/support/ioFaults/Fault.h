#pragma once

#include <string>

namespace ioFaults {

/// What becomes of a call.
enum class Fate {
    pass,    ///< as without us
    fail,    ///< -1 and errno, nothing done
    shorten, ///< a write of half the bytes
    tear     ///< a write of half the bytes, then the end of the process
};

/// Counts a call on a file and decides on it; other files and an empty path pass uncounted. Kills
/// the process where the environment asks for it. Sets errno where the call fails.
Fate fateOf(const char* call, const std::string& path);

/// Path of what a descriptor is open on; empty where the system does not say.
std::string pathOf(int descriptor);
/// Path relative to a folder's descriptor (or AT_FDCWD) as an absolute one, links not followed.
std::string pathAt(int folder, const char* path);
/// Whether a descriptor is open for writing.
bool isWritten(int descriptor);

/// The system call itself, past our own `syscall`.
long systemCall(
    long number, long a = 0, long b = 0, long c = 0, long d = 0, long e = 0, long f = 0);
[[noreturn]] void killProcess();

} // namespace ioFaults
