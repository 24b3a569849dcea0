#include "probe/Deflate.h"

#include "unit/probe/decodePng.h"

#include <gtest/gtest.h>

#include <random>

using namespace fpm;
using Bytes = std::vector<std::uint8_t>;

TEST(Deflate, MakesTheStreamOfTheSpecificationForNoBytes)
{
    // header, empty fixed block (3 bits and end of block), Adler-32 of nothing
    EXPECT_EQ(zlibCompress({}), (Bytes{0x78, 0x01, 0x03, 0x00, 0, 0, 0, 1}));
}

TEST(Deflate, EndsWithTheAdlerChecksum)
{
    const Bytes text{'W', 'i', 'k', 'i', 'p', 'e', 'd', 'i', 'a'};

    const Bytes stream = zlibCompress(text);

    EXPECT_EQ(test::bigEndian(stream, stream.size() - 4), 0x11E60398u);
}

TEST(Deflate, ComesBackForEveryKindOfContent)
{
    std::mt19937 random(7);
    for (const std::size_t size : {1u, 2u, 3u, 257u, 258u, 259u, 600u, 40000u, 100000u}) {
        for (const unsigned kinds : {1u, 3u, 256u}) {
            Bytes bytes(size);
            for (auto& byte : bytes) byte = std::uint8_t(random() % kinds);
            EXPECT_EQ(test::FixedInflate(zlibCompress(bytes)).bytes(), bytes)
                << size << " bytes of " << kinds << " kinds";
        }
    }
}

TEST(Deflate, FindsRepeatsAtTheFarEndOfItsWindow)
{
    std::mt19937 random(3);
    Bytes bytes(32767);
    for (auto& byte : bytes) byte = std::uint8_t(random());
    const Bytes once = bytes;
    bytes.insert(bytes.end(), once.begin(), once.end());

    const Bytes stream = zlibCompress(bytes);

    EXPECT_EQ(test::FixedInflate(stream).bytes(), bytes);
    EXPECT_LT(stream.size(), zlibCompress(once).size() + 700);
}
