#pragma once

#include "io/OutputFolder.h"

#include <cstdint>

namespace fpm {

/// A file that grows at its end and can be read meanwhile. Throws Error(fileIo).
class GrowingFile
{
public:
    /// An empty file; what was there is lost.
    GrowingFile(const OutputFolder& output, const std::string& file);
    /// A file there is, to go on after its first `size` bytes; what follows them is cut off. The
    /// file must begin with `head`. Throws Error(checkpoint) where it is shorter or does not.
    static GrowingFile resume(const OutputFolder& output,
                              const std::string& file,
                              std::string_view head,
                              std::uint64_t size);

    /// One write of the system; where it fails, the file has nothing of `text`.
    void append(std::string_view text);
    /// Waits until all of it is on the disk.
    void synchronise() const;
    std::uint64_t size() const { return size_; } ///< bytes

private:
    GrowingFile(const OutputFolder& output, const std::string& file, int flags);
    void cut(std::uint64_t size) const;

    OutputFolder output_;
    std::filesystem::path path_;
    Descriptor out_;
    std::uint64_t size_ = 0;
};

} // namespace fpm
