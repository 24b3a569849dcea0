#include "kernels/contact/narrow/Overlap.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

/// A contactor that stays where it was found, `depth` inside.
struct Resting {
    float overlap;
    double injected[2]{};
    StepClock clock;
    ContactPassView<DoublePrecision> pair{};
    double depth;

    explicit Resting(double inside) : overlap(notLess(inside)), depth(inside)
    {
        pair.contactorCount = 1;
        pair.overlap = &overlap;
        pair.clock = &clock;
    }
    /// Depth that makes force.
    double felt() { return -relievedGap<DoublePrecision>(pair, 0, -depth, 1); }
};

TEST(Overlap, WhatIsForgivenMakesNoForce)
{
    for (const double depth : {0.1, 1. / 3, 1e-7, 12345.6789}) {
        Resting rest(depth);
        for (int n = 0; n < 100; ++n) EXPECT_LE(rest.felt(), 0);
        EXPECT_GE(rest.felt(), -2e-7 * depth);
    }
}

TEST(Overlap, ALongRampFallsInAStraightLine)
{
    Resting rest(1. / 3);
    const int steps = 1 << 21;
    rest.pair.injected = rest.injected;
    rest.pair.fadeTime = 1;
    rest.clock.step = 1. / steps;
    for (int n = 1; n <= steps; ++n) {
        rest.clock.time = n * rest.clock.step;
        const double felt = rest.felt();
        if (n % (steps / 8) == 0) {
            EXPECT_NEAR(felt, rest.depth * n / steps, 1e-3 * rest.depth) << n;
        }
    }
    EXPECT_NEAR(rest.injected[0], 0.5 * rest.depth * rest.depth, 1e-6);
}

} // namespace
} // namespace fpm
