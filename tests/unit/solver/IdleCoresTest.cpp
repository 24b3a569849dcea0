#include "solver/backend/IdleCores.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

TEST(IdleCores, CountsTheTasksThatRunBesideThisOne)
{
    EXPECT_EQ(otherTasks("0.50 0.40 0.30 3/512 4711\n"), 2);
    EXPECT_EQ(otherTasks("7.00 0.40 0.30 1/512 4711"), 0);
    EXPECT_EQ(otherTasks("0.50 0.40"), 0);
    EXPECT_EQ(otherTasks(""), 0);
}

TEST(IdleCores, SpeaksOnlyWhereThreadsWouldShareCores)
{
    EXPECT_EQ(busyCoresNote(2, false, 4, 2), "");
    EXPECT_EQ(busyCoresNote(1, false, 2, 8), "") << "one thread waits for nobody";
    EXPECT_NE(busyCoresNote(4, false, 4, 1).find("-threads 3"), std::string::npos);
    EXPECT_NE(busyCoresNote(8, false, 2, 0).find("-threads 2"), std::string::npos);
    EXPECT_NE(busyCoresNote(2, false, 2, 5).find("-threads 1"), std::string::npos);
    EXPECT_NE(busyCoresNote(4, true, 4, 1).find("begins with 3 of 4"), std::string::npos);
}

TEST(IdleCores, AddsUpWhatItsCoresHadLeft)
{
    // user nice system idle iowait irq softirq
    const std::string stat = "cpu 900 900 900 900 900 0 0\ncpu0 10 3 20 100 5 0 0\n"
                             "cpu1 10 4 20 200 6 0 0\ncpu12 10 5 20 400 7 0 0\nintr 1 2 3\n";
    EXPECT_EQ(idleTicks(stat, {0, 12}, false), 512);
    EXPECT_EQ(idleTicks(stat, {0, 12}, true), 520);
    EXPECT_EQ(idleTicks(stat, {0, 2}, false), -1) << "not all of them are there";
    EXPECT_EQ(idleTicks("", {0}, false), -1);
}

TEST(IdleCores, ThreadsFollowWithinHalfACore)
{
    EXPECT_EQ(threadsFor(2, 2, 2), 2);
    EXPECT_EQ(threadsFor(1.5, 2, 2), 2);
    EXPECT_EQ(threadsFor(1.4, 2, 2), 1) << "another program works";
    EXPECT_EQ(threadsFor(1.6, 1, 2), 1);
    EXPECT_EQ(threadsFor(1.9, 1, 2), 2) << "it has ended";
    EXPECT_EQ(threadsFor(0.3, 1, 2), 1);
    EXPECT_EQ(threadsFor(9, 3, 8), 8);
    EXPECT_EQ(threadsFor(3.2, 8, 8), 3);
}

TEST(IdleCores, AFixedNumberOfThreadsIsKept)
{
    Control control;
    control.backend = "openmp";
    EXPECT_TRUE(followsIdleCores(control));
    control.threads = 2;
    EXPECT_FALSE(followsIdleCores(control));
    control.threads = 0;
    setenv("OMP_NUM_THREADS", "3", 1);
    EXPECT_FALSE(followsIdleCores(control));
    unsetenv("OMP_NUM_THREADS");
    control.backend = "serial";
    EXPECT_FALSE(followsIdleCores(control));
}

TEST(IdleCores, CountsOneThreadAtLeastAndItsMostAtMost)
{
    IdleCores cores(1);
    EXPECT_EQ(cores.threads(), 1);
    EXPECT_EQ(cores.mean(), 1);
    EXPECT_FALSE(ownCores().empty());
}

} // namespace
} // namespace fpm
