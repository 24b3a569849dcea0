#include "io/FullDiskPolicy.h"

#include "io/FileError.h"

#include <algorithm>
#include <thread>

namespace fpm {

void FullDiskPolicy::attempt(const std::filesystem::path& file,
                             const std::function<void()>& write) const
{
    constexpr std::chrono::milliseconds longest{5000};
    auto next = pause;
    for (bool hasWaited = false;; hasWaited = true) {
        try {
            write();
            if (hasWaited && tell) tell("there is room again: wrote " + file.string());
            return;
        } catch (const FileError& error) {
            if (!waits || !error.isFullDisk()) throw;
        }
        if (!hasWaited && tell) tell("disk full: waiting for room for " + file.string());
        waitForRoom(file, next);
        next = std::min(2 * next, longest);
    }
}

void FullDiskPolicy::waitForRoom(const std::filesystem::path& file,
                                 std::chrono::milliseconds time) const
{
    constexpr std::chrono::milliseconds longest{100}; // that a signal waits
    for (auto left = time; left.count() > 0; left -= longest) {
        if (shouldStop && shouldStop())
            throw Error(ExitCode::stopped,
                        "stopped while the disk was full, waiting for room for " + file.string(),
                        "what was there before is untouched");
        std::this_thread::sleep_for(std::min(left, longest));
    }
}

} // namespace fpm
