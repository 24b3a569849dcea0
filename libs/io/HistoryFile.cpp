#include "io/HistoryFile.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/Table.h"

namespace fpm {

HistoryFile::HistoryFile(GrowingFile rows, const std::string& file, std::size_t columns)
    : rows_(std::move(rows)),
      file_(file),
      columnCount_(columns)
{
}

HistoryFile::HistoryFile(const OutputFolder& output,
                         const std::string& file,
                         const std::vector<std::string>& columns,
                         const std::vector<std::string>& notes)
    : HistoryFile(GrowingFile(output, file), file, columns.size())
{
    rows_.append(tableHead(file, columns, notes));
}

HistoryFile HistoryFile::resume(const OutputFolder& output,
                                const std::string& file,
                                const std::vector<std::string>& columns,
                                const std::vector<std::string>& notes,
                                std::uint64_t size)
{
    return {GrowingFile::resume(output, file, tableHead(file, columns, notes), size), file,
            columns.size()};
}

void HistoryFile::append(std::initializer_list<double> values)
{
    requireCount(values.size());
    rows_.append(tableRow(file_, values));
}

void HistoryFile::append(const std::vector<double>& values)
{
    requireCount(values.size());
    rows_.append(tableRow(file_, values));
}

void HistoryFile::requireCount(std::size_t count) const
{
    if (count != columnCount_)
        throw Error(ExitCode::internal,
                    format("{}: {} values for {} columns", file_, count, columnCount_));
}

} // namespace fpm
