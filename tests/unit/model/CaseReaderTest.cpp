#include "model/CaseReader.h"

#include "support/logFile.h"
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

TEST(CaseReader, NamesTheUnitsOfWhatTablesHold)
{
    const std::array<std::string, 3> engineer{"mm", "tonne", "s"}, fast{"mm", "kg", "ms"},
        imperial{"inch", "slinch", "s"};
    EXPECT_EQ(unitOf(Quantity::force, engineer), "N");
    EXPECT_EQ(unitOf(Quantity::energy, engineer), "mJ");
    EXPECT_EQ(unitOf(Quantity::moment, engineer), "N*mm");
    EXPECT_EQ(unitOf(Quantity::acceleration, engineer), "mm/s^2");
    EXPECT_EQ(unitOf(Quantity::spin, fast), "rad/ms");
    EXPECT_EQ(unitOf(Quantity::force, fast), "kN");
    EXPECT_EQ(unitOf(Quantity::energy, fast), "J");
    EXPECT_EQ(unitOf(Quantity::force, imperial), "slinch*inch/s^2");
    EXPECT_EQ(unitOf(Quantity::momentum, fast), "kN*ms");
    EXPECT_EQ(unitOf(Quantity::angularMomentum, engineer), "N*mm*s");
    EXPECT_EQ(unitOf(Quantity::none, imperial), "-");
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
        Log log = test::logInto(folder.logFile());
        checkUnits({steel(7.85e-9)}, {"mm", "tonne", "s"}, log);
    }
    EXPECT_EQ(folder.logText(), "");
    {
        Log log = test::logInto(folder.logFile());
        checkUnits({steel(7850)}, {"mm", "tonne", "s"}, log);
    }
    EXPECT_TRUE(contains(folder.logText(), "warning: part 'rod': its wave speed would be 0.006"));
}

TEST(CaseReader, QuestionsADensityThatCancelsInTheWaveSpeed)
{
    // Both a thousand times too large, as with kilograms for tonnes.
    const test::CaseFolder folder;
    Part part = steel(7.85e-6);
    part.youngsModulus *= 1000;
    {
        Log log = test::logInto(folder.logFile());
        checkUnits({part}, {"mm", "tonne", "s"}, log);
    }
    EXPECT_TRUE(contains(folder.logText(), "warning: part 'rod': its density would be 7.85e+06"));
    for (const double density : {2e-12, 2.3e-8}) { // aerogel, osmium
        part.density = density;
        part.youngsModulus = density * 1e12;
        Log log = test::logInto(folder.logFile());
        checkUnits({part}, {"mm", "tonne", "s"}, log);
        EXPECT_EQ(folder.logText(), "") << density;
    }
    // A rigid part has no wave speed, but a density.
    part.kind = PartKind::rigidFree;
    part.density = 7850;
    Log log = test::logInto(folder.logFile());
    checkUnits({part}, {"mm", "tonne", "s"}, log);
    EXPECT_TRUE(contains(folder.logText(), "its density would be 7.85e+15"));
}

TEST(CaseReader, QuestionsGravityInOtherUnits)
{
    const auto said = [](double value, std::array<std::string, 3> units,
                         std::vector<std::array<double, 2>> rows = {{0.0, 1.0}}) {
        const test::CaseFolder folder;
        BoundaryCondition gravity;
        gravity.kind = BoundaryCondition::Kind::gravity;
        gravity.name = "g";
        gravity.value = {0, 0, -value};
        gravity.amplitude.rows = rows;
        BoundaryCondition force = gravity; // of any size
        force.kind = BoundaryCondition::Kind::force;
        force.value = {1e9, 0, 0};
        Log log = test::logInto(folder.logFile());
        checkGravity({force, gravity}, units, log);
        return folder.logText();
    };
    EXPECT_EQ(said(9.81, {"mm", "tonne", "s"}),
              "warning: gravity 'g': its acceleration would be 0.00981 m/s2, gravity is 9.81 and "
              "loads of its kind 0.1 to 1000; is 9.81 in the units of constant/caseProperties (mm "
              "tonne s)? 9.81 m/s2 are 9810 there\n");
    EXPECT_EQ(said(9810, {"mm", "tonne", "s"}), "");
    EXPECT_EQ(said(9.81, {"m", "kg", "s"}), "");
    EXPECT_EQ(said(9.81e-3, {"mm", "kg", "ms"}), "");
    EXPECT_NE(said(9.81, {"mm", "kg", "ms"}), "");
    EXPECT_EQ(said(0, {"m", "kg", "s"}), "");
    // The amplitude counts.
    EXPECT_EQ(said(1, {"m", "kg", "s"}, {{0, 0}, {1, 9.81}}), "");
    EXPECT_NE(said(9.81, {"m", "kg", "s"}, {{0, 0}, {1, 1e4}}), "");
}
