#include "study/Chart.h"

#include "study/ChartReport.h"
#include "support/logFile.h"
#include "unit/case/TemporaryCase.h"
#include "unit/model/Refusal.h"
#include "unit/study/fakePrograms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace fpm;
using fpm::test::contains;

namespace {

/// A case whose history is t + 1/n^2, n being an entry of controlDict: order two by construction.
class ChartTest : public testing::Test
{
protected:
    ChartTest()
    {
        folder_.write("system/controlDict", "n 1;\nfunctions { tip { type point; } }\n");
    }
    /// The log of the chart.
    std::string chart(const std::string& values,
                      const std::string& reference,
                      const std::string& more = "",
                      const std::string& probe = "displacement.dat\"; y y;") const
    {
        const auto file = folder_.root() / "log";
        {
            Log log = test::logInto(file);
            const auto text =
                "charts { c { cost elementSteps; " + more + " ladders { n { entry controlDict.n; "
                + "values (" + values + "); order inverse; } } probes { tip { file "
                + "\"postProcessing/tip/0/" + probe + " reference { " + reference + " } } } } }";
            runCharts(Case(folder_.root()), Dictionary::parse(text, "chartDict"), {},
                      Pipeline(programs_.path()), log);
        }
        return folder_.read("log");
    }
    std::string result(const std::string& name) const
    {
        return folder_.read("postProcessing/chart/c/" + name);
    }
    /// A word of chart.dat.
    std::string cell(const std::string& run, const std::string& column) const
    {
        std::istringstream lines(result("chart.dat"));
        std::vector<std::string> names;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream text(line);
            std::vector<std::string> words;
            for (std::string word; text >> word;) words.push_back(word);
            if (words.size() > 1 && words[1] == "run") names = {words.begin() + 1, words.end()};
            if (words[0] != run) continue;
            for (std::size_t i = 0; i < names.size(); ++i)
                if (names[i] == column) return words.at(i);
        }
        return "";
    }

    TemporaryCase folder_;
    test::FakePrograms programs_;
};

} // namespace

TEST_F(ChartTest, MeasuresErrorAndOrderAgainstAFormula)
{
    const auto log = chart("1 2 4", "expression \"t\";", "tolerance 0.3;");

    // |1/n^2| over the root mean square of t at eleven points, by trapezoids.
    EXPECT_NEAR(std::stod(cell("n_2", "tip.L2")), 0.25 / std::sqrt(0.335), 1e-5);
    EXPECT_NEAR(std::stod(cell("n_4", "tip.final")), 1 / 16., 1e-6);
    EXPECT_NEAR(std::stod(cell("n_4", "tip.order")), 2, 1e-3);
    EXPECT_EQ(cell("n_1", "tip.order"), "-");
    EXPECT_EQ(cell("n_4", "elementSteps"), "2560");
    EXPECT_TRUE(contains(log, "for 30 % on tip (L2 over time) use n 4: 2560 element-steps, error "
                              "11 %; no finer one is there to confirm it"));
}

TEST_F(ChartTest, AdvisesTheCheapestWithinTheTolerance)
{
    const auto log = chart("1 2 4", "expression \"t\";", "tolerance 0.5;");

    EXPECT_TRUE(contains(log, "for 50 % on tip (L2 over time) use n 2: 160 element-steps, error "
                              "43 %; the finer n 4 holds it too, 11 % at 16 times the cost"));
    EXPECT_TRUE(contains(chart("1 2 4", "expression \"t\";"),
                         "nothing here reaches 1 % on tip (L2 over time): the best is n 4: 11 % "
                         "at 2560 element-steps"));
}

TEST_F(ChartTest, AdvisesNoRungThatOnlyCrossesTheReference)
{
    // y = t + 1/n^2 passes t + 0.27 at n = 2 and ends 0.21 below it.
    const std::string reference = "expression \"t + 0.27\";";
    EXPECT_TRUE(contains(chart("1 2 4", reference, "tolerance 0.03;"),
                         "nothing here reaches 3 % on tip (L2 over time): n 2: 2.4 % at 160 "
                         "element-steps, but the finer n 4 25 %: it crosses the reference there "
                         "and does not converge to it"));
    EXPECT_TRUE(contains(chart("1 2 4 5", "expression \"t\";", "tolerance 0.5;"),
                         "; the 2 finer ones hold it too, at most 11 % at 39 times the cost"));
    // In whatever order the rungs are written.
    EXPECT_TRUE(contains(chart("4 2 1", reference, "tolerance 0.03;"), "nothing here reaches 3 %"));
    EXPECT_TRUE(contains(chart("1 2 4", reference, "tolerance 0.26;"), "use n 2: 160"));
}

TEST_F(ChartTest, AFinerRungWithoutResultConfirmsNothing)
{
    EXPECT_TRUE(contains(chart("1 4 110", "expression \"t\";", "tolerance 0.3;"),
                         "n 4: 11 % at 2560 element-steps, but the finer n 110 has no result "
                         "(numerical stop (fpmExplicit, status 10))"));
}

TEST_F(ChartTest, NeverAdvisesTheReferenceItself)
{
    const auto log = chart("2 4", "finest n;");

    EXPECT_TRUE(
        contains(log, "nothing here reaches 1 % on tip (L2 over time): the best is n 2: 30 %"));
    EXPECT_EQ(cell("n_4", "tip.front"), "no");
    EXPECT_TRUE(contains(chart("4", "finest n;"),
                         "nothing here reaches 1 % on tip (L2 over time): the only run with a "
                         "result is the reference itself, n 4"));
}

TEST_F(ChartTest, EstimatesTheExactSolutionFromTheFinestRungsAndSaysSo)
{
    const auto log = chart("1 2 4", "finest n;", "tolerance 0.5;");

    EXPECT_NEAR(std::stod(cell("n_2", "tip.L2")), 0.25 / std::sqrt(0.335), 1e-4);
    EXPECT_NEAR(std::stod(cell("n_4", "tip.L2")), 0.0625 / std::sqrt(0.335), 1e-4);
    EXPECT_TRUE(contains(log,
                         "Richardson's estimate from n 2 and 4, observed order 2 (an estimate, no "
                         "exact solution)"));
    EXPECT_TRUE(contains(result("chart.dat"), "Richardson's estimate"));
    EXPECT_TRUE(contains(result("tip.svg"), "estimated error of tip"));
}

TEST_F(ChartTest, TakesTheFinestRungItselfWhereThereIsNoOrder)
{
    const auto log = chart("2 4", "finest n;", "tolerance 0.5;");

    EXPECT_NEAR(std::stod(cell("n_2", "tip.final")), 0.1875 / 1.0625, 1e-5);
    EXPECT_EQ(cell("n_4", "tip.L2"), "0");
    EXPECT_TRUE(contains(log, "use n 2: 160 element-steps, error 30 %; the only finer one is the "
                              "reference itself; errors against the finest rung, n 4"));
    EXPECT_TRUE(contains(result("tip.svg"), "difference of tip to n 4"));
    EXPECT_TRUE(contains(log, "the finest rung, n 4, whose own error is not known"));
}

TEST_F(ChartTest, DrawsFailedRunsHollowWithTheirCause)
{
    chart("1 110 4", "expression \"t\";");

    EXPECT_EQ(cell("n_110", "state"), "fpmExplicit:10");
    EXPECT_EQ(cell("n_110", "tip.L2"), "-");
    EXPECT_EQ(cell("n_110", "tip.front"), "no");
    EXPECT_TRUE(contains(result("tip.svg"), "110: numerical stop (fpmExplicit, status 10)"));
    EXPECT_TRUE(contains(result("tip.svg"), "fill=\"#ffffff\" stroke=\"#0072B2\""));
    EXPECT_TRUE(contains(result("tip.svg"), "Pareto front"));
}

TEST_F(ChartTest, RefusesAHistoryOfAnotherRunThanStatusNames)
{
    chart("1 2", "expression \"t\";");
    const std::string run = "postProcessing/chart/c/runs/n_2/",
                      table = run + "postProcessing/tip/0/displacement.dat";
    folder_.write(table,
                  "# fpm run one postProcessing/tip/0/displacement.dat\n" + folder_.read(table));
    folder_.write(run + "status", "state finished; runId two;\n");

    try {
        chart("1 2", "expression \"t\";");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "displacement.dat is of run one, but"));
        EXPECT_TRUE(contains(error.what(), "n_2/status names run two"));
    }
}

TEST_F(ChartTest, NewReferencesAndProbesRunNothingAgain)
{
    chart("1 2", "expression \"t\";");
    programs_.forgetCalls();

    const auto log = chart("1 2", "expression \"t + 1\";", "repeats 1;");

    EXPECT_EQ(programs_.calls(), "");
    EXPECT_TRUE(contains(log, "2 of 2 runs are finished already"));
    EXPECT_EQ(cell("n_1", "tip.L2"), "0");
}

TEST_F(ChartTest, NamesTheColumnsAndFilesARunHas)
{
    EXPECT_TRUE(contains(
        test::refusal([&] { chart("1 2", "expression \"t\";", "", "displacement.dat\"; y uz;"); }),
        "uz"));
    EXPECT_TRUE(contains(
        test::refusal([&] { chart("1 2", "expression \"t\";", "", "velocity.dat\"; y y;"); }),
        "there are displacement.dat"));
}

TEST_F(ChartTest, SetsInAllRunsWhatIsFixedAndTellsTheOrderOfGivenSteps)
{
    folder_.write("half/system/controlDict", "n 2;\nm 0;\nfunctions { tip { type point; } }\n");
    const auto file = folder_.root() / "log";
    Log log = test::logInto(file);
    runCharts(Case(folder_.root()),
              Dictionary::parse("charts { c { cost elementSteps; fixed { half { overlay half; } } "
                                "ladders { n { entries (controlDict.n controlDict.m); "
                                "values ((2 7) (4 7)); names (coarse fine); steps (0.5 0.25); } } "
                                "probes { tip { file \"postProcessing/tip/0/displacement.dat\"; "
                                "y y; reference { expression \"t\"; } } } } }",
                                "chartDict"),
              {}, Pipeline(programs_.path()), log);

    EXPECT_EQ(folder_.read("postProcessing/chart/c/runs/n_fine/system/controlDict").substr(0, 11),
              "n 4;\nm 7;\nf");
    EXPECT_NEAR(std::stod(cell("n_fine", "tip.order")), 2, 1e-3);
    EXPECT_TRUE(contains(result("tip.svg"), ">fine<"));
}

TEST_F(ChartTest, ShowsOtherPrograms)
{
    chart("1 2", "expression \"t\";",
          "foreign { rival { cost 12; error 0.03; note \"two cores\"; } "
          "hidden { cost 12; error 0.03; probe tip; } third { cost 7; errors { tip 0.25; } } }");

    EXPECT_TRUE(contains(result("tip.svg"), "rival, two cores"));
    EXPECT_TRUE(contains(result("tip.svg"), "other programs"));
    EXPECT_TRUE(contains(result("chart.dat"), "# other program third: cost 7, tip 0.25"));
    EXPECT_TRUE(contains(test::refusal([&] {
                             chart("1 2", "expression \"t\";",
                                   "foreign { third { cost 7; errors { top 0.25; } } }");
                         }),
                         "unknown keyword 'top'"));
}

TEST_F(ChartTest, HoldsTheCurveOfAnotherProgramAgainstTheSameReference)
{
    folder_.write("reference/rival.csv", "t,y\n0,0.1\n1,1.1\n");
    chart("1 2", "expression \"t\";",
          "foreign { rival { cost 12; file \"reference/rival.csv\"; x t; y y; probe tip; } }");

    // 0.1 over the root mean square of t by the trapezoid over its two points, 1/2.
    EXPECT_TRUE(contains(result("chart.dat"), "# other program rival: cost 12, tip 0.1414"));
    EXPECT_TRUE(contains(result("tip.svg"), ">rival<"));
    const auto refused = test::refusal(
        [&] { chart("1 2", "expression \"t\";", "foreign { rival { cost 12; probe tip; } }"); });
    EXPECT_TRUE(contains(refused, "has one of error, errors and file"));
}

TEST(ParetoFront, HoldsWhatNothingBeats)
{
    const double none = std::nan("");

    EXPECT_EQ(paretoFront({1, 2, 3, 4}, {4, 5, 2, 2}),
              (std::vector<bool>{true, false, true, false}));
    EXPECT_EQ(paretoFront({1, 1, 2}, {3, 3, 3}), (std::vector<bool>{true, false, false}));
    EXPECT_EQ(paretoFront({1, 2}, {none, 1}), (std::vector<bool>{false, true}));
}
