#include "probe/Times.h"

#include "base/Error.h"

#include <gtest/gtest.h>

using namespace fpm;

namespace {

const std::vector<FrameTime> frames{
    {"0", 0}, {"5e-05", 5e-5}, {"0.0001", 1.0003e-4}, {"0.00015", 1.5e-4}};

std::vector<std::string> chosen(std::string_view text)
{
    std::vector<std::string> names;
    for (const auto& [name, time] : chooseFrames(frames, parseTimes(text)).frames)
        names.push_back(name);
    return names;
}

} // namespace

TEST(Times, AreNumbersRangesAndTheLatest)
{
    EXPECT_EQ(chosen("1e-4"), (std::vector<std::string>{"0.0001"}));
    EXPECT_EQ(chosen("0:6e-5"), (std::vector<std::string>{"0", "5e-05"}));
    EXPECT_EQ(chosen("latestTime,0"), (std::vector<std::string>{"0", "0.00015"}));
    EXPECT_EQ(chosen("5e-5,5e-5"), (std::vector<std::string>{"5e-05"}));
}

TEST(Times, WithoutAFrameAreReportedAndNotReplaced)
{
    const ChosenFrames result = chooseFrames(frames, parseTimes("1.25e-4,2e-4"));

    EXPECT_TRUE(result.frames.empty());
    EXPECT_EQ(result.missing, (std::vector<double>{1.25e-4, 2e-4}));
}

TEST(Times, OfAFolderWithoutFramesAreAllMissing)
{
    EXPECT_EQ(chooseFrames({}, parseTimes("0,latestTime")).missing.size(), 1u);
}

TEST(Times, RefuseWhatIsNotATime)
{
    for (const char* text : {"", "now", "1,", "1e999", "nan", "1:2:3", "1,5 ms"})
        EXPECT_THROW(parseTimes(text), Error) << text;
}
