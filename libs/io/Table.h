#pragma once

#include "io/OutputFolder.h"

#include <filesystem>
#include <span>
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
/// Whole table at once, complete or absent; `file` is relative to `output`.
void writeTable(const OutputFolder& output, const std::string& file, const Table& table);

/// The lines above the rows of a table file: notes and names of the columns.
std::string tableHead(const std::filesystem::path& file,
                      const std::vector<std::string>& columns,
                      const std::vector<std::string>& notes);
/// A row of one, with its line end.
std::string tableRow(const std::filesystem::path& file, std::span<const double> values);

} // namespace fpm
