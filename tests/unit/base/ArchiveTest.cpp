#include "base/Archive.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

enum class Colour : std::uint8_t { red, green };

struct Record {
    double number = 0;
    bool flag = false;
    Colour colour = Colour::red;
    std::array<double, 2> pair{};
    std::string text;
    std::vector<std::string> names;

    void keep(Archive& archive)
    {
        archive(number);
        archive(flag);
        archive(colour);
        archive(pair);
        archive(text);
        archive.list(names, [](Archive& each, std::string& name) { each(name); });
    }
};

std::vector<std::byte> bytesOf(Record record)
{
    Archive archive;
    record.keep(archive);
    return archive.bytes();
}

Record sample()
{
    return {0.1, true, Colour::green, {1, -2}, "plate", {"a", "", "long name"}};
}

TEST(Archive, GivesBackWhatItWasGiven)
{
    Archive archive(bytesOf(sample()));
    Record back;
    back.keep(archive);
    EXPECT_TRUE(archive.atEnd());
    EXPECT_EQ(back.number, 0.1);
    EXPECT_TRUE(back.flag);
    EXPECT_EQ(back.colour, Colour::green);
    EXPECT_EQ(back.pair, (std::array<double, 2>{1, -2}));
    EXPECT_EQ(back.text, "plate");
    EXPECT_EQ(back.names, (std::vector<std::string>{"a", "", "long name"}));
}

TEST(Archive, RefusesBytesThatEndEarlyWhereverTheyDo)
{
    const std::vector<std::byte> whole = bytesOf(sample());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        Archive archive({whole.begin(), whole.begin() + std::ptrdiff_t(size)});
        Record back;
        EXPECT_THROW(back.keep(archive), Error) << size;
    }
}

TEST(Archive, AsksForNoMemoryThatItsBytesCannotFill)
{
    Archive count;
    std::uint64_t huge = std::uint64_t(1) << 60;
    count(huge);
    std::string text;
    Archive claims(count.bytes());
    EXPECT_THROW(claims(text), Error);
    std::vector<double> values;
    Archive again(count.bytes());
    EXPECT_THROW(again.list(values, [](Archive& each, double& value) { each(value); }), Error);
}

/// A list of many small entries that are large in memory: as many are made as the bytes fill.
TEST(Archive, MakesNoMoreEntriesThanItsBytesFill)
{
    Archive out;
    std::uint64_t claimed = 1000;
    out(claimed);
    std::vector<std::byte> bytes = out.bytes();
    bytes.resize(bytes.size() + 1000);
    std::vector<std::array<double, 50>> values;
    Archive back(bytes);
    EXPECT_THROW(
        back.list(values, [](Archive& each, std::array<double, 50>& value) { each(value); }),
        Error);
    EXPECT_LE(values.size(), 3u);
}

/// A byte that is no bool would be one that is neither true nor false.
TEST(Archive, ReadsATruthFromAnyByte)
{
    for (const int byte : {0, 1, 2, 255}) {
        Archive archive(std::vector{std::byte(byte)});
        bool value = byte == 0;
        archive(value);
        EXPECT_EQ(int(value), byte == 0 ? 0 : 1);
    }
}

} // namespace
} // namespace fpm
