#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fpm {

/// A .dat or .csv table: notes after '#', a line naming the columns (after '#' in .dat), then rows
/// of numbers.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    std::vector<std::string> notes = {}; ///< lines above the names of the columns, without '#'

    /// Index of a column; throws Error(dictionary) listing the columns there are.
    std::size_t column(const std::string& name) const;
    std::vector<double> values(const std::string& name) const;
};

/// Reads whitespace- (.dat) or comma-separated (.csv) columns. The line before the first row names
/// them, with or without '#'; other '#' lines are comments; an empty .csv cell is NaN. A last line
/// cut short (.dat: one without line end) is ignored. Throws Error(fileIo) with file and line.
Table readTable(const std::filesystem::path& file);
/// Whole table at once, complete or absent.
void writeTable(const std::filesystem::path& file, const Table& table);

/// A history that grows by one line a sample: notes, "# time ux uy uz", then shortest round-trip
/// numbers.
/// Each line is flushed, so that it can be plotted while the run goes on. Throws Error(fileIo).
class HistoryFile
{
public:
    HistoryFile(const std::filesystem::path& file,
                const std::vector<std::string>& columns,
                const std::vector<std::string>& notes = {});
    static HistoryFile resume(const std::filesystem::path& file,
                              const std::vector<std::string>& columns,
                              const std::vector<std::string>& notes,
                              std::uint64_t offset);
    std::uint64_t size();
    void synchronise();
    void append(std::initializer_list<double> values);
    void append(const std::vector<double>& values);

private:
    explicit HistoryFile(std::size_t n) : columnCount_(n) {}
    void requireCount(std::size_t count) const;
    void write(const std::string& text);

    std::ofstream stream_;
    std::filesystem::path file_;
    std::size_t columnCount_;
};

} // namespace fpm
