#include "model/CaseReader.h"

#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

#include <cmath>

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

Part steel(double density)
{
    Part part;
    part.name = "rod";
    part.density = density;
    part.youngsModulus = 210000;
    part.poissonsRatio = 0.3;
    return part;
}

} // namespace

TEST(CaseReader, ReadsTitleAndUnits)
{
    const auto properties = readCaseProperties(
        Dictionary::parse("title \"A test\"; units { length m; mass kg; time ms; }"));

    EXPECT_EQ(properties.title, "A test");
    EXPECT_EQ(properties.units, (std::array<std::string, 3>{"m", "kg", "ms"}));
    EXPECT_DOUBLE_EQ(metresPerSecond(properties.units), 1000);
}

TEST(CaseReader, RefusesAUnitItDoesNotKnow)
{
    EXPECT_TRUE(contains(refusal([] {
                             readCaseProperties(Dictionary::parse(
                                 "units { length millimetre; mass kg; time s; }"));
                         }),
                         "millimetre"));
}

TEST(CaseReader, ComputesTheSpeedOfCompressionWaves)
{
    // lambda + 2 mu = E (1 - nu) / ((1 + nu) (1 - 2 nu)) = 282692.3 MPa; steel: 6001 m/s
    EXPECT_NEAR(waveSpeed(steel(7.85e-9)), 6.001e6, 1e3);
}

TEST(CaseReader, AcceptsSteelAndQuestionsADensityInOtherUnits)
{
    const test::CaseFolder folder;
    {
        Log log(folder.logFile());
        checkUnits({steel(7.85e-9)}, {"mm", "tonne", "s"}, log);
    }
    EXPECT_EQ(folder.logText(), "");
    {
        Log log(folder.logFile());
        checkUnits({steel(7850)}, {"mm", "tonne", "s"}, log);
    }
    EXPECT_TRUE(contains(folder.logText(), "warning: part 'rod': its wave speed would be 0.006"));
}
