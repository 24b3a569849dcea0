#include "study/Continuation.h"

#include "case/CheckpointLabel.h"
#include "io/Hdf5File.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

/// A run to 1e-4 with checkpoints of these times and steps of 1e-6, and the same case with another
/// controlDict.
class ContinuationTest : public testing::Test
{
protected:
    static constexpr const char* given = "writeInterval 2.5e-5; historyInterval 5e-6;\n";

    void ran(const std::string& control, const std::vector<double>& times)
    {
        left.write("system/controlDict", control);
        left.write("status", "state stopped;\nrunId \"one\";\n");
        left.write("case.vtkhdf.series", "{}");
        for (std::size_t age = 0; age < times.size(); ++age) {
            const CheckpointLabel label{"one", times[age], 7, 1e-6, 2.5, 4.5};
            Hdf5Image().save(OutputFolder(left.root()), checkpointFileOf(int(age)), label.text());
        }
    }
    Continuation to(const std::string& control, Frames frames = Frames::notNeeded) const
    {
        wanted.write("system/controlDict", control);
        return continuationOf(OutputFolder(left.root()), wanted.root(), frames);
    }
    bool has(int age) const { return left.has(checkpointFileOf(age)); }

    const TemporaryCase left, wanted;
};

} // namespace

TEST_F(ContinuationTest, WhatWasStoppedGoesOnFromItsNewestCheckpoint)
{
    ran("endTime 1e-4;", {9.9e-5, 5e-5});
    const Continuation found = to("endTime 1e-4;");
    EXPECT_TRUE(found.goesOn) << found.why;
    EXPECT_EQ(found.time, 9.9e-5);
    EXPECT_EQ(found.wallSeconds, 2.5);
    EXPECT_EQ(found.cpuSeconds, 4.5);
    EXPECT_TRUE(has(0) && has(1));
}

TEST_F(ContinuationTest, ALongerRunGoesOnFromAnEndThatItMeetsToo)
{
    ran(std::string("endTime 1e-4;") + given, {1e-4, 5e-5});
    EXPECT_EQ(to(std::string("endTime 3e-4;") + given).time, 1e-4);
    EXPECT_TRUE(has(0));
}

TEST_F(ContinuationTest, StepsCutForTheEndOfThenAreLeftOut)
{
    const std::string other = "writeInterval 3e-5; historyInterval 5e-6;\n";
    ran("endTime 1e-4;" + other, {1e-4, 9.8e-5, 5e-5});
    EXPECT_EQ(to("endTime 3e-4;" + other).time, 5e-5);
    EXPECT_FALSE(has(0)) << "a continued run would begin there";
    EXPECT_FALSE(has(1));
    EXPECT_TRUE(has(2));
}

TEST_F(ContinuationTest, ARowThatALongerRunWouldNotTakeIsAnotherResult)
{
    const std::string other = "writeInterval 2.5e-5; historyInterval 3e-6;\n";
    ran("endTime 1e-4;" + other, {1e-4});
    const Continuation found = to("endTime 3e-4;" + other);
    EXPECT_FALSE(found.goesOn);
    EXPECT_NE(found.why.find("cut to meet endTime 0.0001"), found.why.npos) << found.why;
}

TEST_F(ContinuationTest, AShorterRunGoesOnFromBeforeItsEnd)
{
    ran(std::string("endTime 1e-4;") + given, {1e-4, 7.5e-5, 5e-5});
    EXPECT_EQ(to(std::string("endTime 7.5e-5;") + given).time, 5e-5);
    EXPECT_EQ(to(std::string("endTime 5e-5;") + given).why,
              "no checkpoint before endTime 5e-05 is left");
}

TEST_F(ContinuationTest, WhatFollowsFromTheEndIsAnotherRun)
{
    for (const std::string other :
         {"historyInterval 5e-6;", "writeInterval 2.5e-5;",
          "writeInterval 2.5e-5; historyInterval 5e-6; quasiStatic { kineticShare 0.1; }"}) {
        ran("endTime 1e-4;" + other, {1e-4});
        const Continuation found = to("endTime 3e-4;" + other);
        EXPECT_FALSE(found.goesOn) << other;
        EXPECT_NE(found.why.find("follows from endTime"), found.why.npos) << found.why;
    }
}

TEST_F(ContinuationTest, FramesThatAreReadLaterMustBeThere)
{
    ran("endTime 1e-4;", {5e-5});
    EXPECT_TRUE(to("endTime 1e-4;", Frames::needed).goesOn);
    std::filesystem::remove(left.root() / "case.vtkhdf.series");
    EXPECT_TRUE(to("endTime 1e-4;").goesOn);
    EXPECT_NE(to("endTime 1e-4;", Frames::needed).why.find("keepFields no"), std::string::npos);
}

TEST_F(ContinuationTest, NothingIsSaidWhereNothingRan)
{
    left.write("system/controlDict", "endTime 1;");
    EXPECT_EQ(to("endTime 1;").why, "");
    left.write("status", "state failed;\nrunId \"one\";\n");
    EXPECT_EQ(to("endTime 1;").why, "there is no checkpoint of it");
    ran("endTime 1;", {0.5});
    left.write("status", "state failed;\nrunId \"another\";\n");
    EXPECT_EQ(to("endTime 1;").why, "there is no checkpoint of it");
}

} // namespace fpm
