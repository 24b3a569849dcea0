#include "base/Hash.h"

#include <gtest/gtest.h>

using namespace fpm;

// Values of the authors' test suite.
TEST(Hash, IsFnv1a)
{
    EXPECT_EQ(hashOf(""), 0xcbf29ce484222325u);
    EXPECT_EQ(hashOf("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(hashOf("foobar"), 0x85944171f73967e8u);
}

TEST(Hash, GoesOnOverTheBytesOfValues)
{
    EXPECT_EQ(hashed(hashed(hashStart, 'a'), 'b'), hashOf("ab"));
    EXPECT_EQ(hashed(hashStart, std::uint32_t(0x62626161)), hashOf("aabb")); // least byte first
    EXPECT_NE(hashed(hashStart, 0.0), hashed(hashStart, -0.0));
}

TEST(Hash, IsWrittenWithSixteenDigits)
{
    EXPECT_EQ(hexText(0), "0000000000000000");
    EXPECT_EQ(hexText(0xfedcba9876543210u), "fedcba9876543210");
}
