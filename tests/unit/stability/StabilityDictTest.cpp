#include "stability/StabilityDict.h"

#include <gtest/gtest.h>

namespace fpm {
namespace {

std::string refusal(const std::string& map)
{
    try {
        readStabilityDict(Dictionary::parse("maps { m { " + map + " } }"));
    } catch (const InputError& error) {
        return std::string(error.what()) + error.advice();
    }
    return "accepted";
}
const std::string x = "x { parameter speed; values (1 2); } ",
                  y = "y { parameter normalScale; values (1 2); } ";

TEST(StabilityDict, ReadsValuesAndRanges)
{
    const MapSpec map =
        readStabilityDict(
            Dictionary::parse("maps { m { scene twoBlocks; x { parameter speed; from 1; to 100; "
                              "points 3; spacing logarithmic; } "
                              + y + "steps 50; limits { energy 0.1; } fixed { meshRatio 2; } } }"))
            .front();
    ASSERT_EQ(map.x.values.size(), 3U);
    EXPECT_NEAR(map.x.values[1], 10, 1e-12);
    EXPECT_EQ(map.limits.steps, 50);
    EXPECT_EQ(map.limits.energy, 0.1);
    EXPECT_EQ(map.fixed.of(parameter::mesh, 0), 2);
    EXPECT_FALSE(map.eigenvalue);
}

TEST(StabilityDict, TheAnnotatedDictionaryReadsAsItStands)
{
    const std::filesystem::path manual = FPM_SOURCE_DIR "/etc/caseDicts/stabilityDict";
    EXPECT_EQ(readStabilityDict(Dictionary::read(manual, manual.parent_path())).size(), 1U);
}

TEST(StabilityDict, RefusesWhatMakesNoMap)
{
    EXPECT_NE(refusal("scene twoBrs; " + x + y).find("twoBars"), std::string::npos);
    EXPECT_NE(refusal("scene twoBars; x { parameter sped; values (1 2); } " + y).find("speed"),
              std::string::npos);
    EXPECT_NE(refusal("scene spinningBlock; " + x + y).find("normalScale"), std::string::npos);
    EXPECT_NE(refusal("scene twoBars; " + x + "y { parameter speed; values (3); } ").find("both"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; x { parameter speed; values (2 1); } " + y).find("larger"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; x { parameter speed; values (-2 1); } " + y).find("> 0"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; " + x + y + "fixed { speed 3; }").find("axis"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; " + x + y + "fixed { speeed 3; }").find("speeed"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; " + x + y + "eigenvalue yes;").find("timeStepFactor"),
              std::string::npos);
    EXPECT_NE(refusal("scene twoBars; " + x + y + "stepps 3;").find("steps"), std::string::npos);
}

} // namespace
} // namespace fpm
