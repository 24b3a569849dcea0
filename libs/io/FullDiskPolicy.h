#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace fpm {

/// What a write does that finds the disk full: fails, or waits for room and tries again.
struct FullDiskPolicy {
    bool waits = false;
    /// Asked while it waits; true ends the wait with Error(stopped).
    std::function<bool()> shouldStop = nullptr;
    /// Gets one line when a write begins to wait, and one when it goes on.
    std::function<void(const std::string&)> tell = nullptr;
    /// Before the second try; each is twice as long as the one before, up to five seconds.
    std::chrono::milliseconds pause{100};

    /// Runs `write`, which leaves nothing behind where it fails, until it succeeds. Throws what
    /// `write` throws, unless this is about a full disk and waits.
    void attempt(const std::filesystem::path& file, const std::function<void()>& write) const;

private:
    void waitForRoom(const std::filesystem::path& file, std::chrono::milliseconds time) const;
};

} // namespace fpm
