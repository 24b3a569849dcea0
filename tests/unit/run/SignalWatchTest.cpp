#include "run/SignalWatch.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

TEST(SignalWatch, NotesEachKindOnce)
{
    SignalWatch watch;
    EXPECT_FALSE(watch.asks());
    raise(SIGUSR1);
    EXPECT_TRUE(watch.asks());
    EXPECT_TRUE(watch.takeCheckpoint());
    EXPECT_FALSE(watch.takeCheckpoint());
    raise(SIGUSR2);
    EXPECT_TRUE(watch.takeFrame());
    EXPECT_FALSE(watch.asks());
    EXPECT_EQ(watch.end(), "");
}

TEST(SignalWatch, NamesTheSignalThatEndsTheRun)
{
    for (const auto& [number, name] : {std::pair{SIGINT, "SIGINT"},
                                       {SIGTERM, "SIGTERM"},
                                       {SIGHUP, "SIGHUP"},
                                       {SIGXCPU, "SIGXCPU"}}) {
        SignalWatch watch;
        raise(number);
        EXPECT_TRUE(watch.asks());
        EXPECT_EQ(watch.end(), name);
    }
}

TEST(SignalWatchDeathTest, TheSecondOneEndsTheProgramAtOnceWhicheverItIs)
{
    EXPECT_EXIT(
        {
            SignalWatch watch;
            raise(SIGHUP);
            raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
}

TEST(SignalWatch, LeavesTheHangupOfANohupIgnoredAndAllAsItWas)
{
    struct sigaction ignore = {}, before = {}, after = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGHUP, &ignore, &before);
    {
        SignalWatch watch;
        raise(SIGHUP);
        EXPECT_EQ(watch.end(), "");
    }
    sigaction(SIGHUP, &before, &after);
    EXPECT_EQ(after.sa_handler, SIG_IGN);
}

} // namespace
} // namespace fpm
