#pragma once

#include "io/GrowingFile.h"

#include <string>
#include <vector>

namespace fpm {

/// A history that grows by one line a sample: notes, "# time ux uy uz", then shortest round-trip
/// numbers; a table that readTable reads, while the run goes on too. Throws Error(fileIo).
class HistoryFile
{
public:
    /// A new one; what was there is lost.
    HistoryFile(const OutputFolder& output,
                const std::string& file,
                const std::vector<std::string>& columns,
                const std::vector<std::string>& notes = {});
    /// One there is, to go on after its first `size` bytes, as size() was; later rows are cut off.
    /// Throws Error(checkpoint) where it is shorter, or has another head.
    static HistoryFile resume(const OutputFolder& output,
                              const std::string& file,
                              const std::vector<std::string>& columns,
                              const std::vector<std::string>& notes,
                              std::uint64_t size);

    void append(std::initializer_list<double> values);
    void append(const std::vector<double>& values);
    std::uint64_t size() const { return rows_.size(); } ///< bytes so far
    /// Waits until all rows are on the disk.
    void synchronise() const { rows_.synchronise(); }

private:
    HistoryFile(GrowingFile rows, const std::string& file, std::size_t columns);
    void requireCount(std::size_t count) const;

    GrowingFile rows_;
    std::string file_;
    std::size_t columnCount_;
};

} // namespace fpm
