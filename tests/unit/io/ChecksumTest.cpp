#include "io/Checksum.h"

#include <gtest/gtest.h>

#include <set>

using namespace fpm;

namespace {

std::string of(const std::string& bytes)
{
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(bytes)));
    return checksum.text();
}

} // namespace

TEST(Checksum, DoesNotDependOnHowTheBytesAreDivided)
{
    const std::string bytes = "the quick brown fox jumps over the lazy dog";

    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        Checksum checksum;
        checksum.add(std::as_bytes(std::span(bytes).first(cut)));
        checksum.add(std::as_bytes(std::span(bytes).subspan(cut)));
        EXPECT_EQ(checksum.text(), of(bytes)) << cut;
    }
}

TEST(Checksum, ChangesWithEveryBit)
{
    const std::string bytes(37, '\0');
    std::set<std::string> seen{of(bytes)};

    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        std::string changed = bytes;
        changed[bit / 8] = char(1 << (bit % 8));
        EXPECT_TRUE(seen.insert(of(changed)).second) << bit;
    }
}

TEST(Checksum, ChangesWithTheLength)
{
    std::set<std::string> seen;

    for (std::size_t length = 0; length < 40; ++length)
        EXPECT_TRUE(seen.insert(of(std::string(length, '\0'))).second) << length;
}

TEST(Checksum, SeparatesNeighbouringTexts)
{
    Checksum first, second;
    first.add(std::string_view("ab"));
    first.add(std::string_view("c"));
    second.add(std::string_view("a"));
    second.add(std::string_view("bc"));

    EXPECT_NE(first.text(), second.text());
}

TEST(Checksum, IsTheSameOnEveryMachine)
{
    EXPECT_EQ(of("fpm"), "a8d0166678619c41");
}
