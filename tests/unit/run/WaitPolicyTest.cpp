#include "run/WaitPolicy.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace fpm {
namespace {

constexpr int notStartedAgain = 77;

/// What the program that is started again finds.
TEST(WaitPolicy, DISABLED_SpinCountIsSet)
{
    ASSERT_NE(std::getenv("GOMP_SPINCOUNT"), nullptr);
    EXPECT_GT(std::atoi(std::getenv("GOMP_SPINCOUNT")), 0);
}

/// Status of a child that asks for it with OMP_WAIT_POLICY set or not.
int statusOfChild(bool chosen)
{
    const pid_t child = fork();
    if (child == 0) {
        unsetenv("GOMP_SPINCOUNT");
        unsetenv("OMP_WAIT_POLICY");
        if (chosen) setenv("OMP_WAIT_POLICY", "active", 1);
        std::string arguments[] = {"test_solver", "--gtest_also_run_disabled_tests",
                                   "--gtest_filter=WaitPolicy.DISABLED_SpinCountIsSet"};
        char* given[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), nullptr};
        shortenSpin(given);
        _exit(notStartedAgain);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(WaitPolicy, StartsTheProgramAgainUnlessTheUserHasChosen)
{
    EXPECT_EQ(statusOfChild(false), 0);
    EXPECT_EQ(statusOfChild(true), notStartedAgain);
}

} // namespace
} // namespace fpm
