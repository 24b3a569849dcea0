#include "io/Table.h"

#include "fuzz/tried.h"
#include "io/RunMark.h"
#include "support/TemporaryFolder.h"

// Any text is a table with as many numbers in a row as it has columns, or refused; with either
// ending.

using namespace fpm;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    static const test::TemporaryFolder folder;
    for (const std::string name : {"a.dat", "a.csv"}) {
        const auto file = folder / name;
        test::writeBytes(file, {reinterpret_cast<const char*>(bytes), size});
        if (const auto mark = markOf(file))
            fuzz::require(!mark->runId.empty() || mark->file != "", "a mark names a file");
        fuzz::tried([&] {
            const Table table = readTable(file);
            fuzz::require(!table.columns.empty(), "a table has columns");
            for (const auto& row : table.rows)
                fuzz::require(row.size() == table.columns.size(), "rows are as long as columns");
            for (const std::string& column : table.columns) table.values(column);
        });
    }
    return 0;
}
