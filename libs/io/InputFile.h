#pragma once

#include "base/ReadObstacle.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace fpm {

/// A regular file opened for reading, once: what is read later is of the same file, whatever its
/// name stands for then. Never blocks on a pipe.
class InputFile
{
public:
    explicit InputFile(const std::filesystem::path& file);
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&&) = delete;
    ~InputFile();

    const std::filesystem::path& name() const { return name_; }
    std::uint64_t size() const { return size_; } ///< bytes
    bool isReadable() const { return fault_.reason.empty(); }
    /// Throws Error(fileIo) where the system does not let it be read, Error(mesh) where it is none.
    void requireReadable() const;
    /// A path for libraries that open files themselves, in this process and its children.
    std::string descriptorPath() const;
    /// Fills the buffer from `offset` on; false at an early end or a read error.
    bool read(std::uint64_t offset, std::span<std::byte> buffer) const;

private:
    std::filesystem::path name_;
    int number_;
    std::uint64_t size_ = 0;
    ReadObstacle fault_; ///< nothing: none
    int cause_ = 0;      ///< of the system, as errno
};

} // namespace fpm
