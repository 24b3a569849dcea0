#include "input/SampleReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fpm {

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(FPM_SOURCE_DIR) / "tests/input/dictionaries";

/// Names of the wrong dictionaries: <name>.dict beside <name>.txt.
std::vector<std::string> wrongDictionaries()
{
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(folder))
        if (file.path().extension() == ".dict") names.push_back(file.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::string fileText(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// As an application answers: exit code, then the message.
std::string answer(const fs::path& dictionary)
{
    try {
        readSample(Dictionary::read(dictionary, folder));
    } catch (const Error& error) {
        const auto advice = error.advice().empty() ? "" : "\n  = " + error.advice();
        return std::to_string(int(error.code())) + "\nerror: " + error.what() + advice + '\n';
    }
    return "0\n";
}

class WrongDictionary : public testing::TestWithParam<std::string>
{};

} // namespace

TEST_P(WrongDictionary, IsAnsweredWithItsMessage)
{
    const auto dictionary = folder / (GetParam() + ".dict");

    EXPECT_EQ(answer(dictionary), fileText(folder / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(Input,
                         WrongDictionary,
                         testing::ValuesIn(wrongDictionaries()),
                         [](const auto& test) { return test.param; });

} // namespace fpm
