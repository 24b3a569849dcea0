#include "probe/Png.h"

#include "unit/probe/decodePng.h"

#include <gtest/gtest.h>

#include <string_view>

using namespace fpm;

namespace {

std::vector<std::uint8_t> bytesOf(std::string_view text)
{
    return {text.begin(), text.end()};
}

} // namespace

TEST(Png, StartsWithSignatureAndHeader)
{
    const auto file = encodePng({2, 1, {{255, 0, 0}, {0, 255, 0}}});

    EXPECT_EQ(test::bigEndian(file, 0), 0x89504E47u);
    EXPECT_EQ(test::bigEndian(file, 16), 2u);
    EXPECT_EQ(test::bigEndian(file, 20), 1u);
}

TEST(Png, EndsWithTheChunkWhoseChecksumIsKnown)
{
    const auto file = encodePng({1, 1, {{1, 2, 3}}});

    EXPECT_EQ(test::bigEndian(file, file.size() - 4), 0xAE426082u); // CRC of "IEND"
}

TEST(Png, GivesBackEveryPixel)
{
    Image image{37, 23, {}};
    for (int i = 0; i < 37 * 23; ++i)
        image.pixels.push_back(
            {std::uint8_t(i * i), std::uint8_t(i / 37 * 9), std::uint8_t(255 - i)});

    const Image read = test::decodePng(encodePng(image));

    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.pixels, image.pixels);
}

TEST(Png, EncodesBase64AsTheSpecificationsExamples)
{
    EXPECT_EQ(base64(bytesOf("")), "");
    EXPECT_EQ(base64(bytesOf("f")), "Zg==");
    EXPECT_EQ(base64(bytesOf("fo")), "Zm8=");
    EXPECT_EQ(base64(bytesOf("foobar")), "Zm9vYmFy");
}
