#include "study/ChartDict.h"

#include "unit/case/TemporaryCase.h"
#include "unit/model/Refusal.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::filesystem::path manuals = std::filesystem::path(FPM_SOURCE_DIR) / "etc/caseDicts";

/// A case of the annotated dictionaries.
class ChartDictTest : public testing::Test
{
protected:
    ChartDictTest()
    {
        for (const std::string file :
             {"constant/caseProperties", "constant/partProperties", "constant/boundaryConditions",
              "0/initialConditions", "system/meshDict", "system/contactDict", "system/controlDict",
              "system/probeDict"})
            folder_.write(file, manual(std::filesystem::path(file).filename()));
        folder_.write("reference/exact.csv", "t,uz\n0,0\n1,2\n");
        folder_.write("variants/quarter/system/user", "");
        folder_.write("variants/whole/system/user", "");
    }
    static std::string manual(const std::string& name) { return test::readBytes(manuals / name); }
    std::vector<ChartSpec> read(const std::string& text) const
    {
        return readChartDict(Dictionary::parse(text, "chartDict"), Case(folder_.root()));
    }
    /// What is answered to a chart with this ladder and this probe.
    std::string answer(const std::string& ladder,
                       const std::string& probe = "file \"postProcessing/tip/0/U.dat\"; y U_z; "
                                                  "reference { expression \"t\"; }") const
    {
        return refusal([&] {
            read("charts { c { ladders { l { " + ladder + " } } probes { p { " + probe
                 + " } } } }");
        });
    }

    TemporaryCase folder_;
};

const std::string fine = "entry meshDict.refinement; values (1 2);";

} // namespace

TEST_F(ChartDictTest, TheAnnotatedDictionaryReadsAsItStands)
{
    const auto charts = read(manual("chartDict"));

    ASSERT_EQ(charts.size(), 1u);
    EXPECT_EQ(charts[0].ladders.size(), 4u);
    EXPECT_EQ(charts[0].probes.size(), 4u);
    EXPECT_TRUE(charts[0].settings.tables);
    EXPECT_EQ(charts[0].settings.timeLimit, 600);
    EXPECT_EQ(productOf(charts[0].ladders).rungs.size(), 24u);
    EXPECT_EQ(productOf(charts[0].ladders).lines.size(), 8u);
    EXPECT_EQ(eachOf(charts[0].ladders).rungs.size(), 9u);
    EXPECT_EQ(eachOf(charts[0].ladders).lines.size(), 4u);
}

TEST_F(ChartDictTest, TheAnnotatedDictionaryShowsEveryKeyTheReaderAsksFor)
{
    const std::string text = manual("chartDict");
    std::set<std::string> shown;
    for (const std::string& path : Dictionary::parse(text).keyPaths()) {
        std::istringstream words(path);
        for (std::string key; std::getline(words, key, '.');) shown.insert(key);
    }
    std::size_t answers = 0;
    for (std::size_t at = text.find("{\n"); at != std::string::npos;
         at = text.find("{\n", at + 1)) {
        std::string message;
        try {
            read(std::string(text).insert(at + 2, "notAKey 1;\n"));
        } catch (const Error& error) {
            message = error.what();
        }
        const std::string mark = "valid here: ";
        const auto start = message.find(mark);
        if (message.find("unknown keyword 'notAKey'") == std::string::npos
            || start == std::string::npos)
            continue;
        ++answers;
        std::istringstream words(message.substr(start + mark.size()));
        for (std::string word; words >> word;) {
            std::erase(word, ',');
            EXPECT_TRUE(shown.count(word)) << "chartDict does not show '" << word << "'";
        }
    }
    EXPECT_GT(answers, 5u);
}

TEST_F(ChartDictTest, SuggestsTheEntryThatWasMeant)
{
    EXPECT_TRUE(contains(answer("entry controlDict.precison; values (double);"),
                         "system/controlDict has no entry 'precison'"));
    EXPECT_TRUE(contains(answer("entry controlDict.precison; values (double);"),
                         "did you mean 'precision'?"));
    EXPECT_TRUE(contains(answer("entry controlDict.timeStep.saftey; values (0.5);"),
                         "did you mean 'safety'?"));
    EXPECT_TRUE(
        contains(answer("entry partProperties.parts.plate7.hourglass.form; values (viscous);"),
                 "did you mean 'plate1'?"));
    EXPECT_TRUE(contains(answer("entry controlDic.precision; values (double);"),
                         "did you mean 'controlDict'?"));
    EXPECT_TRUE(contains(answer("entry precision; values (double);"), "names no entry"));
}

TEST_F(ChartDictTest, TakesEntriesThatOnlyTheManualKnows)
{
    folder_.write("system/controlDict",
                  "endTime 1; functions { f { type energies; } } timeStep { safety 0.9; }");
    folder_.write("system/contactDict", "pairs { mine { contactor a; target b; } }");
    const auto charts = read(
        "charts { c { ladders { a { entry controlDict.massScaling.factor; values (1 4); } "
        "b { entry controlDict.timeStep.contactLimit; values (0.5 1); } "
        "d { entry contactDict.pairs.mine.normalScale; values (1 2); } } "
        "probes { p { file \"postProcessing/f/0/energies.dat\"; y total; reference { finest a; } } "
        "} } }");

    EXPECT_EQ(charts[0].ladders[2].changes[0][0].path, "pairs.mine.normalScale");
    EXPECT_FALSE(charts[0].settings.tables);
    EXPECT_TRUE(contains(answer("entry contactDict.pairs.mine.normalSkale; values (1);"),
                         "did you mean 'normalScale'?"));
}

TEST_F(ChartDictTest, RefusesLaddersWithoutSense)
{
    EXPECT_TRUE(contains(answer("entry meshDict.refinement; values (1 1);"), "stands here twice"));
    EXPECT_TRUE(contains(answer("entry meshDict.refinement; values ();"), "at least one value"));
    EXPECT_TRUE(
        contains(answer("entry meshDict.refinement; values (1 fine);"), "needs values > 0"));
    EXPECT_TRUE(contains(answer("overlay (none \"variants/half\");"), "no folder 'variants/half'"));
    EXPECT_TRUE(contains(answer("overlay (\"../other\");"), "leads upwards"));
    folder_.write("postProcessing/chart/c/chart.dat", "");
    for (const std::string folder : {"postProcessing", ".", "postProcessing/chart/c"})
        EXPECT_TRUE(contains(answer("overlay (none \"" + folder + "\");"),
                             "'" + folder + "' cannot be laid over copies of the case"))
            << folder;
}

TEST_F(ChartDictTest, SetsSeveralEntriesTogetherUnderAName)
{
    const auto charts = read(
        "charts { c { fixed { one { entry contactDict.surfaces.wall.normal; value (0 0 2); } "
        "quarter { overlay \"variants/quarter\"; } } ladders { "
        "form { entries (partProperties.parts.plate1.hourglass.form "
        "partProperties.parts.plate1.hourglass.coefficient); "
        "values ((viscous 0.1) (physical 1)); names (viscous physical); } "
        "mesh { overlay (none \"variants/quarter\"); names (2 \"0.5 mm\"); steps (2 0.5); } } "
        "probes { p { file \"postProcessing/tip/0/U.dat\"; y U_z; reference { finest mesh; } } } } "
        "}");

    const auto& form = charts[0].ladders[0];
    EXPECT_EQ(form.values, (std::vector<std::string>{"viscous", "physical"}));
    ASSERT_EQ(form.changes[1].size(), 2u);
    EXPECT_EQ(form.changes[1][0].value, "physical");
    EXPECT_EQ(form.changes[1][1].path, "parts.plate1.hourglass.coefficient");
    EXPECT_EQ(form.changes[1][1].value, "1");
    EXPECT_TRUE(form.steps.empty());
    EXPECT_EQ(charts[0].ladders[1].steps, (std::vector<double>{2, 0.5}));
    EXPECT_TRUE(charts[0].ladders[1].changes[0].empty());
    EXPECT_EQ(productOf(charts[0].ladders).rungs[3].label, "form physical, mesh 0.5 mm");
    ASSERT_EQ(charts[0].fixed.size(), 2u);
    EXPECT_EQ(charts[0].fixed[0].overlay, "variants/quarter") << "folders come first";
    EXPECT_EQ(charts[0].fixed[1].value, "(0 0 2)");
}

TEST_F(ChartDictTest, KnowsTheEntriesThatAFixedFolderBrings)
{
    folder_.write("variants/quarter/system/meshDict", "cells 4;\nbodies { }\n");
    const std::string rest = "probes { p { file \"postProcessing/tip/0/U.dat\"; y U_z; "
                             "reference { expression \"t\"; } } } } }";
    const std::string ladders = "ladders { n { entry meshDict.cells; values (4 8); } } ";

    EXPECT_EQ(
        read("charts { c { fixed { q { overlay \"variants/quarter\"; } } " + ladders + rest).size(),
        1u);
    EXPECT_TRUE(contains(refusal([&] { read("charts { c { " + ladders + rest); }),
                         "system/meshDict has no entry 'cells'"));
}

TEST_F(ChartDictTest, RefusesRowsNamesAndStepsThatAreNotOneAValue)
{
    const std::string two = "entries (controlDict.precision controlDict.threads); ";
    EXPECT_TRUE(
        contains(answer(two + "values ((double 1) single);"), "'single' is no row of 2 values"));
    EXPECT_TRUE(contains(answer(two + "values ((double 1 2));"), "is no row of 2 values"));
    EXPECT_TRUE(contains(answer("entries (controlDict.precison); values ((double));"),
                         "did you mean 'precision'?"));
    EXPECT_TRUE(contains(answer(fine + "names (a);"), "1 names for 2 values"));
    EXPECT_TRUE(contains(answer(fine + "names (a a);"), "stands here twice"));
    EXPECT_TRUE(contains(answer(fine + "steps (1 0.5 0.2);"), "3 steps for 2 values"));
    EXPECT_TRUE(contains(answer(fine + "steps (1 0);"), "steps are > 0"));
    EXPECT_TRUE(
        contains(refusal([&] {
                     read("charts { c { fixed { n { entry controlDict.thread; value 1; } } } }");
                 }),
                 "did you mean 'threads'?"));
}

TEST_F(ChartDictTest, RefusesWidthsAndLimitsBelowZero)
{
    EXPECT_TRUE(
        contains(refusal([&] { read("charts { c { runTimeLimit -1; } }"); }), "'runTimeLimit'"));
    EXPECT_TRUE(contains(answer(fine, "file \"postProcessing/tip/0/U.dat\"; y U_z; average -1; "
                                      "reference { expression \"t\"; }"),
                         "'average'"));
}

TEST_F(ChartDictTest, RefusesProbesThatNothingWrites)
{
    const auto probe = [&](const std::string& text) { return answer(fine, text); };

    EXPECT_TRUE(contains(probe("file \"postProcessing/rodCenter/0/u.dat\"; y uz; "
                               "reference { expression \"t\"; }"),
                         "did you mean 'rodCentre'?"));
    EXPECT_TRUE(contains(probe("file \"tip.dat\"; y uz; reference { expression \"t\"; }"),
                         "a probe is a file in postProcessing"));
    const std::string tip = "file \"postProcessing/tip/0/U.dat\"; y U_z; ";
    EXPECT_TRUE(contains(probe(tip + "reference { }"), "a reference is one of"));
    EXPECT_TRUE(
        contains(probe(tip + "reference { expression \"sine(t)\"; }"), "did you mean 'sin'?"));
    EXPECT_TRUE(contains(probe(tip + "reference { finest n; }"), "'finest' must be one of l"));
    EXPECT_TRUE(contains(probe(tip + "reference { file \"reference/exact.csv\"; x t; y u; }"),
                         "reference/exact.csv has no column 'u'"));
    EXPECT_TRUE(contains(probe(tip + "reference { file \"reference/none.csv\"; x t; y u; }"),
                         "the case has no file 'reference/none.csv'"));
    EXPECT_TRUE(contains(probe(tip + "reference { table ((1 0) (0 0)); }"), "must ascend"));
    EXPECT_TRUE(contains(probe(tip + "reference { table ((1 0)); }"), "at least two rows"));
}
