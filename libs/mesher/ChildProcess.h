#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace fpm {

/// What a child process may use beyond what its parent does; 0 = no limit.
struct ChildLimits {
    std::uint64_t memoryBytes = 0;
    std::uint64_t cpuSeconds = 0;
};

/// Runs `work` in a child process and returns the bytes it returned, so that a library that crashes
/// on a hostile file takes nothing with it. An Error thrown by `work` is thrown here again; a child
/// that dies is Error(mesh): "<subject>: rejected, ...".
std::string inChild(const std::string& subject,
                    const ChildLimits& limits,
                    const std::function<std::string()>& work);

} // namespace fpm
