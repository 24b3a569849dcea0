#include "model/PartReader.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::string plastic =
    "model elastoplastic; density 1; youngsModulus 1000; poissonsRatio 0.25; ";
const std::string line = plastic + "yieldStress 10; plasticModulus 50; ";
const std::string curve =
    "johnsonCook { A 90; B 292; n 0.31; C 0.025; rate0 2; m 1.09; melt 1356; } ";

Part readOne(const std::string& entries)
{
    return readParts(Dictionary::parse("parts { block { " + entries + " } }"),
                     test::boxMesh({{"block", {0, 0, 0}, {1, 1, 1}}}))
        .front();
}

std::string refusalOf(const std::string& entries)
{
    return refusal([&] { readOne(entries); });
}

double slope(const Part& part)
{
    return part.hardening[1].yieldStress - part.hardening[0].yieldStress;
}

} // namespace

TEST(MaterialReader, APlainPartHasNoFlowOfItsOwnAndIsNeverDeleted)
{
    const Part part = readOne(line);
    EXPECT_EQ(part.flow, Flow{});
    EXPECT_FALSE(part.erosion.any());
}

TEST(MaterialReader, TakesTheTangentModulusForThePlasticOne)
{
    EXPECT_NEAR(slope(readOne(plastic + "yieldStress 10; tangentModulus 200;")), 250, 1e-12);
    EXPECT_TRUE(contains(refusalOf(plastic + "yieldStress 10; tangentModulus 1000;"),
                         "a tangent modulus of 1000 is not below Young's modulus 1000"));
    EXPECT_TRUE(contains(refusalOf(line + "tangentModulus 20;"),
                         "'plasticModulus' and 'tangentModulus' both describe the hardening"));
}

TEST(MaterialReader, SplitsTheModulusBetweenGrowthAndMotion)
{
    const Part added = readOne(line + "kinematic { modulus 30; }");
    EXPECT_EQ(added.flow.kinematicModulus, 30);
    EXPECT_NEAR(slope(added), 50, 1e-12);
    const Part split = readOne(line + "kinematic { fraction 0.4; }");
    EXPECT_NEAR(split.flow.kinematicModulus, 20, 1e-12);
    EXPECT_NEAR(slope(split), 30, 1e-12);
    EXPECT_TRUE(contains(refusalOf(line + "kinematic { fraction 0.4; modulus 3; }"),
                         "'fraction' and 'modulus' both describe the kinematic hardening"));
    EXPECT_TRUE(contains(refusalOf(plastic + "hardening table ((0 5)); kinematic { fraction 1; }"),
                         "a fraction is that of a straight line's plastic modulus"));
    EXPECT_TRUE(contains(refusalOf(line + "kinematic { fraction 1.5; }"), "between 0 and 1"));
}

TEST(MaterialReader, ReadsRateLaws)
{
    const Flow cowper = readOne(line + "rate { law cowperSymonds; D 40; p 5; }").flow;
    EXPECT_EQ(cowper.rate, RateDependence::cowperSymonds);
    EXPECT_EQ(cowper.referenceRate, 40);
    EXPECT_NEAR(cowper.rateCoefficient, 0.2, 1e-15);
    const Flow cook = readOne(line + "rate { law johnsonCook; C 0.02; rate0 3; }").flow;
    EXPECT_EQ(cook.rate, RateDependence::johnsonCook);
    EXPECT_EQ(cook.rateCoefficient, 0.02);
    EXPECT_EQ(readOne(line + "rate { law none; }").flow, Flow{});
    EXPECT_TRUE(contains(refusalOf(line + "rate { law cowperSymmonds; D 40; p 5; }"),
                         "did you mean 'cowperSymonds'?"));
    EXPECT_TRUE(contains(refusalOf(line + "rate { law cowperSymonds; D 40; p 0.5; }"),
                         "between 1 and 100"));
    EXPECT_TRUE(contains(refusalOf(line + "rate { law cowperSymonds; D 40; }"), "p"));
    EXPECT_TRUE(contains(refusalOf(plastic + curve + "rate { law cowperSymonds; D 40; p 5; }"),
                         "'johnsonCook' has a rate term of its own, C"));
}

TEST(MaterialReader, ReadsJohnsonAndCookWithHeating)
{
    const Part part = readOne(plastic + curve + "heating { specificHeat 3.83e8; }");
    EXPECT_EQ(part.hardening.size(), 1u);
    EXPECT_EQ(part.hardening[0].yieldStress, 90);
    EXPECT_EQ(part.flow.powerModulus, 292);
    EXPECT_EQ(part.flow.powerExponent, 0.31);
    EXPECT_EQ(part.flow.referenceRate, 2);
    EXPECT_EQ(part.flow.softeningExponent, 1.09);
    EXPECT_EQ(part.flow.meltingTemperature, 1356);
    EXPECT_EQ(part.flow.heatFraction, 0.9);
    EXPECT_EQ(part.flow.temperature, 293);
    EXPECT_TRUE(contains(refusalOf(line + curve),
                         "'yieldStress' and 'johnsonCook' both describe the yield stress"));
    EXPECT_TRUE(
        contains(refusalOf(plastic + "johnsonCook { A 90; B 292; n 0.31; C 0.1; }"), "rate0"));
    EXPECT_TRUE(contains(refusalOf(plastic + "johnsonCook { A 90; B 292; n 0.31; m 1; melt 200; }"),
                         "> 293"));
    EXPECT_TRUE(contains(refusalOf(plastic + "johnsonCook { A 90; B 292; n 1.31; }"), "<= 1"));
    EXPECT_TRUE(contains(refusalOf(line + "heating { fraction 0.9; }"), "specificHeat"));
}

TEST(MaterialReader, TheNearestPartThatSpeaksOfHardeningDecides)
{
    const auto parts = readParts(
        Dictionary::parse("parts { a { " + line
                          + "rate { law cowperSymonds; D 40; p 5; } } "
                            "b { like a; hardening table ((0 7) (0.1 8)); rate { law none; } } "
                            "c { like a; tangentModulus 200; } }"),
        test::boxMesh({{"a", {0, 0, 0}, {1, 1, 1}},
                       {"b", {2, 0, 0}, {1, 1, 1}},
                       {"c", {4, 0, 0}, {1, 1, 1}}}));
    EXPECT_EQ(parts[1].hardening[0].yieldStress, 7);
    EXPECT_EQ(parts[1].flow, Flow{});
    EXPECT_NEAR(slope(parts[2]), 250, 1e-12);
    EXPECT_EQ(parts[2].flow.rate, RateDependence::cowperSymonds);
}

TEST(MaterialReader, ReadsWhenElementsAreDeleted)
{
    EXPECT_EQ(readOne(line + "erosion { plasticStrain 0.8; }").erosion.plasticStrain, 0.8);
    EXPECT_TRUE(readOne(line + "erosion { inverted yes; }").erosion.inverted);
    EXPECT_TRUE(
        contains(refusalOf(line + "erosion { }"), "'erosion' says not when elements are deleted"));
    EXPECT_TRUE(contains(refusalOf(line + "erosion { plasticStrain -1; }"), "> 0"));
    EXPECT_TRUE(contains(refusalOf("model rigidPrescribed; erosion { inverted yes; }"),
                         "'erosion' has no meaning for a rigid part"));
}

TEST(MaterialReader, RefusesATableLongerThanTheKernelsHold)
{
    std::string rows;
    for (int i = 0; i < 33; ++i) {
        rows += '(';
        rows += std::to_string(i);
        rows += " 10) ";
    }
    EXPECT_TRUE(
        contains(refusalOf(plastic + "hardening table (" + rows + ");"), "the table has 33 rows"));
}

TEST(MaterialReader, ChecksWhatAnElasticPartDoesNotUse)
{
    const std::string elastic =
        "model elastic; density 1; youngsModulus 1000; poissonsRatio 0.25; ";
    const Part part = readOne(elastic + "yieldStress 10; kinematic { modulus 30; }");
    EXPECT_EQ(part.flow, Flow{});
    EXPECT_TRUE(part.hardening.empty());
    EXPECT_TRUE(contains(refusalOf(elastic + "yieldStress -1;"), "yieldStress"));
}
