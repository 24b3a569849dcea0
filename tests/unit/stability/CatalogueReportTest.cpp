#include "stability/CatalogueReport.h"

#include "base/Error.h"
#include "io/Table.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace fpm {
namespace {

std::string textOf(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(Catalogue, HasEveryNumberAndSaysWhyAVariantLoses)
{
    std::set<int> numbers;
    std::set<std::string> names;
    for (const Failure& failure : catalogue()) {
        numbers.insert(failure.number);
        EXPECT_TRUE(names.insert(failure.name).second) << failure.name;
        EXPECT_NE(failure.expected[0], Fate::none) << failure.name;
        EXPECT_FALSE(failure.fails.empty() || failure.quantity.empty() || failure.remedy.empty())
            << failure.name;
        for (const Fate fate : failure.expected) {
            EXPECT_FALSE(fate == Fate::loses && failure.note.empty()) << failure.name;
            EXPECT_FALSE(fate == Fate::holds && failure.reason.empty()) << failure.name;
        }
        EXPECT_NE(failure.expected[2], Fate::loses) << failure.name << " has no remedy then";
    }
    EXPECT_EQ(numbers.size(), 27u);
    EXPECT_EQ(*numbers.rbegin(), 27);
}

TEST(Catalogue, IsTheOneInTheDocuments)
{
    // Not its figures: those belong to the machine; what holds and what loses does not.
    const std::string document = textOf(FPM_SOURCE_DIR "/doc/failures.md"),
                      limits = textOf(FPM_SOURCE_DIR "/doc/limits.md");
    for (const Failure& failure : catalogue()) {
        const auto begin = document.find("| `" + failure.name + "` |");
        ASSERT_NE(begin, std::string::npos)
            << failure.name << ": run bin/fpmStability -catalogue -to doc";
        const std::string row = document.substr(begin, document.find('\n', begin) - begin);
        EXPECT_NE(row.find(failure.fails), std::string::npos) << row;
        for (const ContactVariant variant : {ContactVariant::standard, ContactVariant::paper})
            if (const Fate fate = failure.expected[std::size_t(variant)]; fate != Fate::none) {
                EXPECT_NE(row.find(nameOf(fate)), std::string::npos) << row;
            }
        if (failure.expected[0] == Fate::loses) {
            EXPECT_NE(limits.find(failure.name), std::string::npos) << "no row in doc/limits.md";
        }
    }
}

TEST(Catalogue, IsChosenByNumberAndName)
{
    EXPECT_EQ(chosenFailures("").size(), catalogue().size());
    const auto chosen = chosenFailures("F22,grooveNode");
    ASSERT_EQ(chosen.size(), 3u);
    EXPECT_EQ(chosen[0]->number, 22);
    EXPECT_EQ(chosen[1]->number, 22);
    EXPECT_EQ(chosen[2]->number, 1);
    for (const char* wrong : {"F28", "groovNode", "F1,,F2"}) try {
            chosenFailures(wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::commandLine);
        }
}

TEST(Catalogue, JudgesByLimitAndWordsAndCatchesWhatBeginsToHold)
{
    Failure failure{.number = 1, .name = "forged", .limit = 1};
    double value = 0;
    failure.run = [&](ContactVariant) { return Measure{value, "", false}; };
    for (const auto& [given, fate] : {std::pair{0.5, Fate::holds},
                                      {1.0, Fate::holds},
                                      {1.5, Fate::loses},
                                      {NAN, Fate::loses}}) {
        value = given;
        EXPECT_EQ(judge(failure, ContactVariant::standard).fate, fate) << given;
    }
    EXPECT_EQ(judge(failure, ContactVariant::remedy).fate, Fate::none);
    failure.atLeast = true;
    value = 0.5;
    EXPECT_EQ(judge(failure, ContactVariant::paper).fate, Fate::loses);

    failure.words = "no";
    failure.run = [](ContactVariant variant) {
        return Measure{0, "oh no", variant == ContactVariant::paper};
    };
    EXPECT_EQ(judge(failure, ContactVariant::standard).fate, Fate::warned);
    EXPECT_EQ(judge(failure, ContactVariant::paper).fate, Fate::refused);
    failure.words = "yes";
    EXPECT_EQ(judge(failure, ContactVariant::paper).fate, Fate::loses);

    failure.expected = {Fate::loses, Fate::loses, Fate::none};
    CatalogueRow row{&failure, {}};
    row.verdicts[0].fate = row.verdicts[1].fate = Fate::loses;
    EXPECT_TRUE(row.isExpected());
    row.verdicts[1].fate = Fate::holds;
    EXPECT_FALSE(row.isExpected());
}

TEST(Catalogue, WritesItsTableAndPicture)
{
    const test::TemporaryFolder folder;
    Log log = Log::quiet();
    runCatalogue("grooveNode,rigidOnRigid", folder.path().string(), 2, log);
    const Table table = readTable(folder.path() / "failures.dat");
    EXPECT_EQ(table.rows.size(), 4u);
    for (const double expected : table.values("expected")) EXPECT_EQ(expected, 1);
    EXPECT_GT(table.values("value")[1], table.values("limit")[1]);
    EXPECT_NE(textOf(folder.path() / "failures.svg").find("grooveNode"), std::string::npos);
    EXPECT_NE(textOf(folder.path() / "failures.md").find("| F24 | `rigidOnRigid` |"),
              std::string::npos);
}

} // namespace
} // namespace fpm
