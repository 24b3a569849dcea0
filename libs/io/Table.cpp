#include "io/Table.h"

#include "base/Error.h"
#include "base/Format.h"
#include "base/ReadObstacle.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

namespace fpm {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool isCsv(const std::filesystem::path& file)
{
    return file.extension() == ".csv";
}

std::vector<std::string_view> cells(std::string_view line, bool csv)
{
    std::vector<std::string_view> found;
    const std::string_view separators = csv ? "," : blanks;
    while (true) {
        const auto end = line.find_first_of(separators);
        const auto cell = trimmed(line.substr(0, end));
        if (csv || !cell.empty()) found.push_back(cell);
        if (end == std::string_view::npos) return found;
        line.remove_prefix(end + 1);
    }
}

/// A missing value (",,") is not a number, and neither is a word.
std::optional<double> number(std::string_view cell)
{
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (cell.front() == '+') cell.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc::result_out_of_range && end == cell.data() + cell.size()) return 0.0;
    if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
    return value;
}

/// Collects the lines of one file; `lastIsWhole`: whether the last one had its line end.
class TableReader
{
public:
    TableReader(const std::filesystem::path& file, bool lastIsWhole)
        : file_(file),
          csv_(isCsv(file)),
          lastIsWhole_(lastIsWhole)
    {
    }

    void take(std::string_view line, bool isLast)
    {
        ++lineNumber_;
        line = trimmed(line);
        if (line.empty()) return;
        if (line.front() == '#') {
            if (table_.columns.empty()) comments_.emplace_back(trimmed(line.substr(1)));
            return;
        }
        const auto texts = cells(line, csv_);
        if (table_.columns.empty() && takeHeader(texts)) return;
        takeRow(texts, isLast);
    }

    Table finish()
    {
        if (table_.columns.empty()) nameColumnsByComment();
        return std::move(table_);
    }

private:
    void nameColumns(const std::vector<std::string_view>& names)
    {
        for (const auto name : names)
            if (!name.empty()) table_.columns.emplace_back(name);
        if (table_.columns.empty()) fail("no line names the columns");
        table_.notes = comments_;
    }

    void nameColumnsByComment()
    {
        const std::string names = comments_.empty() ? "" : comments_.back();
        if (!comments_.empty()) comments_.pop_back();
        nameColumns(cells(names, csv_));
    }

    /// The line before the first row names the columns, with or without '#'.
    bool takeHeader(const std::vector<std::string_view>& texts)
    {
        if (number(texts.front())) {
            nameColumnsByComment();
            return false;
        }
        nameColumns(texts);
        return true;
    }

    void takeRow(const std::vector<std::string_view>& texts, bool isLast)
    {
        const bool cut = isLast && !lastIsWhole_;
        // Histories end every line; a hand-made .csv often ends without.
        if (cut && (!csv_ || texts.size() != table_.columns.size())) return;
        if (texts.size() != table_.columns.size())
            fail(
                format("{} values, but {} columns are named", texts.size(), table_.columns.size()));
        std::vector<double> row;
        for (const auto text : texts) {
            const auto value = number(text);
            if (!value) fail("expected a number, got '" + std::string(text) + "'");
            row.push_back(*value);
        }
        table_.rows.push_back(std::move(row));
    }

    [[noreturn]] void fail(const std::string& reason) const
    {
        throw Error(ExitCode::fileIo,
                    format("table {}:{}: {}", file_.string(), lineNumber_, reason),
                    "expected a line of column names, then rows of as many numbers");
    }

    std::filesystem::path file_;
    bool csv_, lastIsWhole_;
    int lineNumber_ = 0;
    std::vector<std::string> comments_; ///< before the first row
    Table table_;
};

} // namespace

std::size_t Table::column(const std::string& name) const
{
    const auto found = std::ranges::find(columns, name);
    if (found != columns.end()) return std::size_t(found - columns.begin());
    std::string names;
    for (const auto& one : columns) names += (names.empty() ? "" : " ") + one;
    throw Error(ExitCode::dictionary, "the table has no column '" + name + "'",
                "columns there are: " + names);
}

std::vector<double> Table::values(const std::string& name) const
{
    const std::size_t index = column(name);
    std::vector<double> found;
    found.reserve(rows.size());
    for (const auto& row : rows) found.push_back(row.at(index));
    return found;
}

Table readTable(const std::filesystem::path& file)
{
    std::error_code failure;
    const auto kind = std::filesystem::status(file, failure).type();
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (kind == std::filesystem::file_type::directory || errno == EACCES) {
        const auto [reason, advice] = readObstacle(file, errno);
        throw Error(ExitCode::fileIo, format("cannot read '{}': {}", file.string(), reason),
                    advice);
    }
    if (kind != std::filesystem::file_type::regular || !stream)
        throw Error(ExitCode::fileIo, "cannot open the table '" + file.string() + "'",
                    "paths are taken from the case folder; was the run that writes it started?");
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    TableReader reader(file, text.ends_with('\n'));
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        reader.take(std::string_view(text).substr(begin, end - begin), end + 1 >= text.size());
        begin = end + 1;
    }
    return reader.finish();
}

void writeTable(const OutputFolder& output, const std::string& file, const Table& table)
{
    std::string text = tableHead(file, table.columns, table.notes);
    for (const auto& row : table.rows) text += tableRow(file, row);
    output.write(file, text);
}

std::string tableHead(const std::filesystem::path& file,
                      const std::vector<std::string>& columns,
                      const std::vector<std::string>& notes)
{
    const bool csv = isCsv(file);
    std::string text;
    for (const auto& note : notes) text += "# " + note + "\n";
    text += csv ? "" : "# ";
    for (std::size_t column = 0; column < columns.size(); ++column)
        text += (column == 0 ? "" : csv ? "," : " ") + columns[column];
    return text + "\n";
}

std::string tableRow(const std::filesystem::path& file, std::span<const double> values)
{
    const char separator = isCsv(file) ? ',' : ' ';
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += separator;
        text += toText(value);
    }
    return text + "\n";
}

} // namespace fpm
