#include "base/Format.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"

#include <gtest/gtest.h>

#include <algorithm>

// Every folder beside this file but `base` is a wrong case: the files of `base` with its own laid
// over them, and `expected`, what the case must be answered with.

using namespace fpm;

namespace {

const std::filesystem::path here = std::filesystem::path(FPM_SOURCE_DIR) / "tests/input/cases";

std::vector<std::string> wrongCases()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(here))
        if (entry.is_directory() && entry.path().filename() != "base")
            names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

/// Exit code, message and advice, as the user gets them from fpmSetContact and fpmExplicit.
std::string answer(const test::CaseFolder& folder)
{
    Log log = Log::quiet();
    try {
        const Case theCase = folder.open();
        Mesh mesh = test::rodAndPlates();
        setContact(mesh, theCase.dictionary("system/contactDict"), theCase, log);
        folder.write(mesh);
        readModel(theCase, log);
    } catch (const Error& error) {
        std::string text = format("exit {}\n{}\n", int(error.code()), error.what());
        if (!error.advice().empty()) text += "advice: " + error.advice() + "\n";
        return text;
    }
    return "exit 0\n";
}

class InputCase : public testing::TestWithParam<std::string>
{};

} // namespace

TEST(InputCases, TheirBaseIsRight)
{
    const test::CaseFolder folder;
    folder.overlay(here / "base");

    EXPECT_EQ(answer(folder), "exit 0\n");
}

TEST_P(InputCase, IsAnsweredAsExpected)
{
    const test::CaseFolder folder;
    folder.overlay(here / "base");
    folder.overlay(here / GetParam());

    EXPECT_EQ(answer(folder), test::readText(here / GetParam() / "expected"));
}

INSTANTIATE_TEST_SUITE_P(Wrong, InputCase, testing::ValuesIn(wrongCases()), [](const auto& wrong) {
    return wrong.param;
});
