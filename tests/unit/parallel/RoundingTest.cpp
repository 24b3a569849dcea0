#include <gtest/gtest.h>

namespace fpm {
namespace {

/// As forces are on their way to the host. g++ 12 joins the two conversions there and back in one
/// register, takes them for nothing and leaves the rounding out, unless an option forbids it.
void throughFloat(const double* from, double* to)
{
    const float first = float(from[0]), second = float(from[1]);
    to[0] = double(first);
    to[1] = double(second);
}

TEST(Rounding, WhatWasRoundedToFloatStaysRounded)
{
    const double exact[2] = {0.1, 0.3};
    double got[2];
    void (*volatile unseen)(const double*, double*) = throughFloat; // not inlined
    unseen(exact, got);
    EXPECT_EQ(got[0], 13421773.0 / 134217728); // 24 bits
    EXPECT_EQ(got[1], 10066330.0 / 33554432);
}

} // namespace
} // namespace fpm
