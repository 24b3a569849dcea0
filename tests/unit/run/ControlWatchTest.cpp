#include "run/ControlWatch.h"

#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace fpm {
namespace {

class ControlWatchTest : public testing::Test
{
protected:
    /// Newer than whatever was there.
    void write(const std::string& text)
    {
        std::ofstream(file_) << text;
        time_ += std::chrono::seconds(1);
        std::filesystem::last_write_time(file_, time_);
    }
    ControlWatch watch()
    {
        return ControlWatch({file_, [this] { return Dictionary::read(file_, folder_.path()); }});
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "controlDict";
    std::filesystem::file_time_type time_ = std::filesystem::file_time_type::clock::now();
    Control control_;
    std::string said_;
    Log log_ = Log::into(said_);
};

TEST_F(ControlWatchTest, TakesOverWhatMayChange)
{
    control_.runTimeModifiable = true;
    control_.endTime = 1;
    write("endTime 1;");
    ControlWatch watched = watch();
    EXPECT_FALSE(watched.follow(control_, log_));
    write("endTime 2; stopAt nextWrite; writeInterval 0.5; massDamping 7; checkpoint { keep 5; }");
    EXPECT_TRUE(watched.follow(control_, log_));
    EXPECT_EQ(control_.endTime, 2);
    EXPECT_EQ(control_.stopAt, StopAt::nextWrite);
    EXPECT_EQ(control_.writeInterval, 0.5);
    EXPECT_EQ(control_.checkpoint.keep, 5);
    EXPECT_EQ(control_.massDamping, 0); // the physics stays
    EXPECT_FALSE(watched.follow(control_, log_));
}

TEST_F(ControlWatchTest, KeepsEverythingWhereOneEntryIsWrong)
{
    control_.runTimeModifiable = true;
    control_.endTime = 1;
    write("endTime 1;");
    ControlWatch watched = watch();
    write("endTime 5; writeInterval -1;");
    EXPECT_FALSE(watched.follow(control_, log_));
    EXPECT_EQ(control_.endTime, 1);
    EXPECT_NE(said_.find("writeInterval"), said_.npos) << said_;
    std::filesystem::remove(file_); // as an editor does for a moment
    EXPECT_FALSE(watched.follow(control_, log_));
    write("endTime 5;");
    EXPECT_TRUE(watched.follow(control_, log_));
    EXPECT_EQ(control_.endTime, 5);
}

TEST_F(ControlWatchTest, IsOffUnlessAskedFor)
{
    control_.endTime = 1;
    write("endTime 1;");
    ControlWatch watched = watch();
    write("endTime 2;");
    EXPECT_FALSE(watched.follow(control_, log_));
    EXPECT_EQ(control_.endTime, 1);
}

} // namespace
} // namespace fpm
