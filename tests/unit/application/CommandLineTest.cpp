#include "application/CommandLine.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

ApplicationInfo info()
{
    return {
        "fpmTest",
        "Does nothing, for tests.",
        "system/testDict",
        {{"threads", "<n>", "Threads"}, {"time", "<t>", "Time"}, {"latestTime", "", "Last time"}},
        false};
}

OptionValues parsed(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "fpmTest");
    std::vector<char*> argv;
    for (auto& argument : arguments) argv.push_back(argument.data());
    return parseCommandLine(info(), int(argv.size()), argv.data());
}

/// Message and advice of the refusal, on one line.
std::string refusal(const std::vector<std::string>& arguments)
{
    try {
        parsed(arguments);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::commandLine);
        return error.what() + std::string(" | ") + error.advice();
    }
    return "";
}

} // namespace

TEST(CommandLine, TakesOneDashOrTwoAndBlankOrEqualsSign)
{
    const OptionValues expected{{"case", "plate"}};

    EXPECT_EQ(parsed({"-case", "plate"}), expected);
    EXPECT_EQ(parsed({"--case", "plate"}), expected);
    EXPECT_EQ(parsed({"-case=plate"}), expected);
    EXPECT_EQ(parsed({"--case=plate"}), expected);
}

TEST(CommandLine, TakesSwitches)
{
    EXPECT_EQ(parsed({"-latestTime", "-noLog"}), (OptionValues{{"latestTime", ""}, {"noLog", ""}}));
    EXPECT_EQ(parsed({"-h"}), (OptionValues{{"help", ""}}));
    EXPECT_EQ(parsed({"-help"}), (OptionValues{{"help", ""}}));
    EXPECT_TRUE(parsed({}).empty());
}

TEST(CommandLine, TakesNegativeValues)
{
    EXPECT_EQ(parsed({"-time", "-1.5"}), (OptionValues{{"time", "-1.5"}}));
    EXPECT_EQ(parsed({"-time", "-1:2"}), (OptionValues{{"time", "-1:2"}}));
}

TEST(CommandLine, SuggestsForAnUnknownOption)
{
    EXPECT_EQ(refusal({"-cas", "x"}), "unknown option -cas | did you mean -case?");
    EXPECT_EQ(refusal({"--thraeds", "4"}), "unknown option --thraeds | did you mean -threads?");
    EXPECT_EQ(refusal({"-colour"}), "unknown option -colour | 'fpmTest -help' lists the options");
}

TEST(CommandLine, DoesNotGuess)
{
    EXPECT_NE(refusal({"-l"}), "");
    EXPECT_NE(refusal({"-latest"}), "");
    EXPECT_NE(refusal({"-t", "4"}), "");
}

TEST(CommandLine, MissesAValue)
{
    EXPECT_EQ(
        refusal({"-case", "-dict", "x"}),
        "option -case needs a value <dir>, found option -dict | 'fpmTest -help' lists the options");
    EXPECT_EQ(refusal({"-case", "--dict"}), "option -case needs a value <dir>, found option --dict "
                                            "| 'fpmTest -help' lists the options");
    EXPECT_TRUE(refusal({"-case"}).starts_with("option -case needs a value <dir>"));
    EXPECT_TRUE(refusal({"-case="}).starts_with("option -case needs a value <dir>"))
        << refusal({"-case="});
    EXPECT_TRUE(refusal({"-case", ""}).starts_with("option -case needs a value <dir>"));
}

TEST(CommandLine, RefusesAValueForASwitch)
{
    EXPECT_TRUE(refusal({"-latestTime=1"}).starts_with("option -latestTime takes no value"));
}

TEST(CommandLine, RefusesAnOptionGivenTwice)
{
    EXPECT_TRUE(refusal({"-case", "a", "-case", "b"}).starts_with("option -case is given twice"));
    EXPECT_TRUE(refusal({"-noLog", "-noLog"}).starts_with("option -noLog is given twice"));
}

TEST(CommandLine, RefusesStrayArguments)
{
    EXPECT_TRUE(refusal({"plate"}).starts_with("unexpected argument 'plate'"));
    EXPECT_TRUE(refusal({"-noLog", "plate"}).starts_with("unexpected argument 'plate'"));
    EXPECT_TRUE(refusal({"--", "-x"}).starts_with("unexpected argument '-x'"));
    EXPECT_NE(refusal({""}), "");
    EXPECT_NE(refusal({"-"}), "");
}

TEST(CommandLine, ExplainsItselfWithOneDash)
{
    const auto text = helpText(info());

    EXPECT_NE(text.find("Usage: fpmTest [options]"), text.npos);
    EXPECT_NE(text.find("  -case <dir>      Case folder (default: .)\n"), text.npos) << text;
    EXPECT_NE(text.find("  -latestTime      Last time\n"), text.npos);
    EXPECT_NE(text.find("(default: system/testDict)"), text.npos);
    EXPECT_EQ(text.find("--"), text.npos);
}

TEST(CommandLine, OffersNoDictionaryOptionsWithoutADictionary)
{
    auto plain = info();
    plain.dictionary.clear();

    EXPECT_EQ(helpText(plain).find("-listKeys"), std::string::npos);
}

} // namespace fpm
