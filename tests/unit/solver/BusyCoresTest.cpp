#include "solver/BusyCores.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

TEST(BusyCores, CountsTheTasksThatRunBesideThisOne)
{
    EXPECT_EQ(otherTasks("0.50 0.40 0.30 3/512 4711\n"), 2);
    EXPECT_EQ(otherTasks("7.00 0.40 0.30 1/512 4711"), 0);
    EXPECT_EQ(otherTasks("0.50 0.40"), 0);
    EXPECT_EQ(otherTasks(""), 0);
}

TEST(BusyCores, SpeaksOnlyWhereThreadsWouldShareCores)
{
    EXPECT_EQ(busyCoresNote(2, 4, 2), "");
    EXPECT_EQ(busyCoresNote(1, 2, 8), "") << "one thread waits for nobody";
    EXPECT_NE(busyCoresNote(4, 4, 1).find("-threads 3"), std::string::npos);
    EXPECT_NE(busyCoresNote(8, 2, 0).find("-threads 2"), std::string::npos);
    EXPECT_NE(busyCoresNote(2, 2, 5).find("-threads 1"), std::string::npos);
}

} // namespace
} // namespace fpm
