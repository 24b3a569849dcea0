#include "model/PartMaterial.h"
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

namespace {

const std::string solid = "density 1; youngsModulus 1000; poissonsRatio 0.25; ";
const std::string soil = "model druckerPrager; " + solid;
const std::string metal = "model zerilliArmstrong; " + solid
                          + "zerilliArmstrong { C0 60; C1 1000; C3 0.007; C4 0.0004; } ";

} // namespace

TEST(MaterialReader, ReadsTheParametersOfAListedMaterialInTheirOrder)
{
    const Part part = readOne(soil + "druckerPrager { frictionAngle 30; cohesion 2; }");
    EXPECT_EQ(part.kind, kindOf<DruckerPrager>);
    EXPECT_EQ(part.lawValues, (std::vector<double>{2, 30, 0}));
    EXPECT_EQ(readOne(metal).lawValues, (std::vector<double>{60, 1000, 0, 0.007, 0.0004, 0, 1, 1}));
}

TEST(MaterialReader, RefusesParametersOfAListedMaterialOutOfRange)
{
    EXPECT_TRUE(contains(refusalOf(soil + "druckerPrager { cohesion 2; frictionAngle 95; }"),
                         ">= 0 and < 90"));
    EXPECT_TRUE(contains(refusalOf(soil + "druckerPrager { cohesion 2; }"), "frictionAngle"));
    EXPECT_TRUE(contains(refusalOf(soil), "druckerPrager"));
    EXPECT_TRUE(contains(
        refusalOf(soil + "druckerPrager { cohesion 2; frictionAngle 20; dilationAngle 21; }"),
        "the angle of dilation is above that of friction"));
    EXPECT_TRUE(contains(
        refusalOf("model zerilliArmstrong; " + solid + "zerilliArmstrong { C0 0; C3 0; C4 0; }"),
        "yields without stress"));
}

TEST(MaterialReader, AListedMaterialTakesNothingOfElastoplastic)
{
    const std::string cone = soil + "druckerPrager { cohesion 2; frictionAngle 30; } ";
    EXPECT_TRUE(contains(refusalOf(cone + "yieldStress 10;"),
                         "'yieldStress' has no meaning for model druckerPrager"));
    EXPECT_TRUE(contains(refusalOf(cone + "heating { specificHeat 3; }"), "'heating' has no"));
    const Part heated = readOne(metal + "heating { specificHeat 3; }");
    EXPECT_EQ(heated.flow.heatFraction, 0.9);
    EXPECT_EQ(readOne(cone + "erosion { plasticStrain 0.3; }").erosion.plasticStrain, 0.3);
}

TEST(MaterialReader, AListedMaterialNotChosenIsCheckedOnly)
{
    const std::string elastic = "model elastic; " + solid;
    EXPECT_TRUE(
        readOne(elastic + "druckerPrager { cohesion 2; frictionAngle 30; }").lawValues.empty());
    EXPECT_TRUE(contains(refusalOf(elastic + "druckerPrager { cohesion 2; frictionAngle 95; }"),
                         "frictionAngle"));
    EXPECT_TRUE(contains(refusalOf("model rigidPrescribed; druckerPrager { cohesion 2; }"),
                         "'druckerPrager' has no meaning for a rigid part"));
}

TEST(MaterialReader, RefusesAnElementInWhichTheMaterialHasNoKernel)
{
    const std::string cone = soil + "druckerPrager { cohesion 2; frictionAngle 30; } ";
    const std::string said = refusalOf(cone + "hourglass { form viscous; }");
    EXPECT_TRUE(contains(said, "model druckerPrager is not there in the element of part 'block'"));
    EXPECT_TRUE(contains(said, "hexahedron reduced with hourglass form physical, hexahedron "
                               "selective"));
    EXPECT_NO_THROW(readOne(cone + "hexahedron selective; hourglass { form viscous; }"));
}
