#include "io/FullDiskPolicy.h"

#include "io/FileError.h"
#include "io/HistoryFile.h"
#include "support/FileSizeLimit.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cerrno>

using namespace fpm;

namespace {

/// Waits without waiting: every pause is nothing.
struct Waiting {
    FullDiskPolicy policy()
    {
        return {.waits = true,
                .shouldStop = [this] { return ++asked >= stopAt; },
                .tell = [this](const std::string& line) { said += line + "\n"; },
                .pause = std::chrono::milliseconds(1)};
    }
    int asked = 0, stopAt = 1000;
    std::string said;
};

/// A write that succeeds at the try of this number.
struct Write {
    int succeedsAt, cause = ENOSPC, tries = 0;
    void operator()()
    {
        if (++tries < succeedsAt) throw FileError("write", "file", cause);
    }
};

} // namespace

TEST(FullDiskPolicy, FailsAtOnceUnlessItWaits)
{
    Write write{2};
    EXPECT_THROW(FullDiskPolicy().attempt("file", std::ref(write)), FileError);
    EXPECT_EQ(write.tries, 1);
}

TEST(FullDiskPolicy, WaitsForRoomAndSaysSoOnce)
{
    for (const int cause : {ENOSPC, EDQUOT}) {
        Waiting waiting;
        Write write{4, cause};
        waiting.policy().attempt("file", std::ref(write));

        EXPECT_EQ(write.tries, 4);
        EXPECT_EQ(waiting.said,
                  "disk full: waiting for room for file\nthere is room again: wrote file\n");
    }
}

TEST(FullDiskPolicy, DoesNotWaitForWhatIsNoFullDisk)
{
    for (const int cause : {EIO, EACCES, EFBIG}) {
        Waiting waiting;
        Write write{2, cause};
        EXPECT_THROW(waiting.policy().attempt("file", std::ref(write)), FileError);
        EXPECT_EQ(waiting.said, "");
    }
}

TEST(FullDiskPolicy, EndsWhenTheRunIsToStop)
{
    Waiting waiting;
    waiting.stopAt = 5;
    Write write{1000};
    try {
        waiting.policy().attempt("file", std::ref(write));
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::stopped);
    }
    EXPECT_EQ(write.tries, 5);
    EXPECT_EQ(waiting.said, "disk full: waiting for room for file\n");
}
