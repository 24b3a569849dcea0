#include "io/Table.h"

#include "base/Error.h"
#include "io/HistoryFile.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

namespace {

Table read(const TemporaryFolder& folder, const std::string& name, const std::string& text)
{
    writeBytes(folder / name, text);
    return readTable(folder / name);
}

std::string refusal(const TemporaryFolder& folder, const std::string& name, const std::string& text)
{
    try {
        read(folder, name, text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::fileIo);
        return error.what();
    }
    return "";
}

} // namespace

TEST(Table, ReadsBothFormats)
{
    const TemporaryFolder folder;

    const Table dat = read(folder, "a.dat", "# by hand\n# time  uz\n0 1\n  1e-6\t-2.5\n");
    const Table csv = read(folder, "a.csv", "time,uz\r\n0,1\r\n1e-6 , -2.5");

    for (const Table& table : {dat, csv}) {
        EXPECT_EQ(table.columns, (std::vector<std::string>{"time", "uz"}));
        EXPECT_EQ(table.values("time"), (std::vector<double>{0, 1e-6}));
        EXPECT_EQ(table.values("uz"), (std::vector<double>{1, -2.5}));
    }
}

TEST(Table, TakesAnEmptyCsvCellAsMissing)
{
    const TemporaryFolder folder;

    const Table table = read(folder, "a.csv", "# source\na,b,c\n1,,3\n");

    EXPECT_TRUE(std::isnan(table.rows.at(0).at(1)));
    EXPECT_EQ(table.rows.at(0).at(2), 3);
}

TEST(Table, IgnoresALastLineCutShort)
{
    const TemporaryFolder folder;

    EXPECT_EQ(read(folder, "a.dat", "# a b\n1 2\n3").rows.size(), 1U);
    EXPECT_EQ(read(folder, "a.dat", "# a b\n1 2\n3 4").rows.size(), 1U)
        << "4 may be 4.25 cut short";
    EXPECT_EQ(read(folder, "a.csv", "a,b\n1,2\n3,4").rows.size(), 2U);
    EXPECT_EQ(read(folder, "a.csv", "a,b\n1,2\n3").rows.size(), 1U);
    EXPECT_EQ(read(folder, "a.dat", "# a b\n").columns.size(), 2U);
}

TEST(Table, NamesTheLineThatIsWrong)
{
    const TemporaryFolder folder;

    EXPECT_NE(refusal(folder, "a.dat", "# a b\n1 2\n3\n4 5\n").find("a.dat:3"), std::string::npos);
    EXPECT_NE(refusal(folder, "a.csv", "a,b\n1,two\n").find("a.csv:2"), std::string::npos);
    EXPECT_NE(refusal(folder, "a.dat", "1 2\n"), "");
    EXPECT_NE(refusal(folder, "a.dat", ""), "");
}

TEST(Table, ListsTheColumnsThereAre)
{
    const Table table{{"time", "uz"}, {}};
    try {
        table.column("uy");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::dictionary);
        EXPECT_NE(error.advice().find("time uz"), std::string::npos);
    }
}

TEST(Table, ReadsBackTheSameNumbers)
{
    const TemporaryFolder folder;
    const Table table{{"a", "b"}, {{0.1, 1.0 / 3}, {-5e-324, 1.7976931348623157e308}}};

    for (const std::string name : {"t.dat", "t.csv"}) {
        writeTable(OutputFolder(folder.path()), name, table);
        const Table back = readTable(folder / name);
        EXPECT_EQ(back.columns, table.columns);
        EXPECT_EQ(back.rows, table.rows);
    }
}

TEST(Table, KeepsTheNotesAboveItsColumns)
{
    const TemporaryFolder folder;
    HistoryFile(OutputFolder(folder.path()), "a.dat", {"time", "ux"},
                {"fpm run one a.dat", "units: s mm"})
        .append({0.5, 1.0});
    writeTable(OutputFolder(folder.path()), "b.csv", {{"t", "u"}, {{1, 2}}, {"a note"}});

    const Table dat = readTable(folder / "a.dat"), csv = readTable(folder / "b.csv");

    EXPECT_EQ(readBytes(folder / "a.dat"),
              "# fpm run one a.dat\n# units: s mm\n# time ux\n0.5 1\n");
    EXPECT_EQ(dat.columns, (std::vector<std::string>{"time", "ux"}));
    EXPECT_EQ(dat.notes, (std::vector<std::string>{"fpm run one a.dat", "units: s mm"}));
    EXPECT_EQ(readBytes(folder / "b.csv"), "# a note\nt,u\n1,2\n");
    EXPECT_EQ(csv.columns, (std::vector<std::string>{"t", "u"}));
    EXPECT_EQ(csv.notes, (std::vector<std::string>{"a note"}));
}
