#include "model/BoundaryReader.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

Amplitude read(const std::string& entry)
{
    return readAmplitude(Dictionary::parse(entry));
}

} // namespace

TEST(Amplitude, IsOneWhereNothingIsSaid)
{
    EXPECT_EQ(read("")(0), 1.0);
    EXPECT_EQ(read("amplitude constant;")(123), 1.0);
}

TEST(Amplitude, RunsStraightBetweenTheRowsOfATable)
{
    const Amplitude table = read("amplitude table ((0 0) (2 4) (3 1));");

    EXPECT_DOUBLE_EQ(table(0.5), 1.0);
    EXPECT_DOUBLE_EQ(table(2.0), 4.0);
    EXPECT_DOUBLE_EQ(table(2.5), 2.5);
}

TEST(Amplitude, HoldsTheFirstAndLastValueOutsideItsRows)
{
    const Amplitude table = read("amplitude table ((1 5) (2 7));");

    EXPECT_DOUBLE_EQ(table(0), 5.0);
    EXPECT_DOUBLE_EQ(table(9), 7.0);
}

TEST(Amplitude, StepsSmoothlyFromRowToRow)
{
    const Amplitude smooth = read("amplitude smooth ((0 0) (4 8) (6 2));");
    const auto step = [](double tau) { return tau * tau * tau * (10 - 15 * tau + 6 * tau * tau); };

    EXPECT_DOUBLE_EQ(smooth(1), 8 * step(0.25));
    EXPECT_DOUBLE_EQ(smooth(2), 4.0);
    EXPECT_DOUBLE_EQ(smooth(5), 5.0);
}

TEST(Amplitude, StartsAndEndsASmoothStepWithoutSlopeOrCurvature)
{
    const Amplitude smooth = read("amplitude smooth ((0 0) (1 1));");
    const double h = 1e-3;

    // The step leaves as 10 tau^3 and arrives likewise.
    EXPECT_NEAR(smooth(h), 10 * h * h * h, 2e-11);
    EXPECT_NEAR(1 - smooth(1 - h), 10 * h * h * h, 2e-11);
}

TEST(Amplitude, RefusesAKindItDoesNotKnow)
{
    const std::string text = refusal([] { read("amplitude smoth ((0 0) (1 1));"); });

    EXPECT_TRUE(contains(text, "unknown amplitude 'smoth'"));
    EXPECT_TRUE(contains(text, "did you mean 'smooth'?"));
}

TEST(Amplitude, RefusesTimesThatDoNotAscend)
{
    EXPECT_TRUE(contains(refusal([] { read("amplitude table ((0 0) (1 1) (1 2));"); }),
                         "times must ascend: 1 follows 1"));
}

TEST(Amplitude, RefusesATableOfOneRow)
{
    EXPECT_TRUE(
        contains(refusal([] { read("amplitude table ((0 0));"); }), "needs at least two rows"));
}
