#include "model/PartReader.h"

#include "unit/model/BoxMesh.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::string elastic = "model elastic; density 1e-9; youngsModulus 1000; poissonsRatio 0.25;";

Mesh meshOf(const std::vector<std::string>& names)
{
    std::vector<test::Box> boxes;
    for (const std::string& name : names)
        boxes.push_back({name, {double(boxes.size()), 0, 0}, {1, 1, 1}});
    return test::boxMesh(boxes);
}

Part readOne(const std::string& entries)
{
    return readParts(Dictionary::parse("parts { block { " + entries + " } }"), meshOf({"block"}))
        .front();
}

std::string refusalOf(const std::string& entries)
{
    return refusal([&] { readOne(entries); });
}

} // namespace

TEST(PartReader, FollowsTheOrderOfTheMesh)
{
    const auto parts =
        readParts(Dictionary::parse("parts { b { " + elastic + " } a { like b; density 2e-9; } }"),
                  meshOf({"a", "b"}));

    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "a");
    EXPECT_EQ(parts[0].density, 2e-9);
    EXPECT_EQ(parts[0].youngsModulus, 1000);
    EXPECT_EQ(parts[1].density, 1e-9);
}

TEST(PartReader, MakesAStraightHardeningLineOfTwoRows)
{
    const Part part = readOne("model elastoplastic; density 1; youngsModulus 10; poissonsRatio 0;"
                              "yieldStress 285; plasticModulus 900;");

    ASSERT_EQ(part.hardening.size(), 2u);
    EXPECT_EQ(part.hardening[0].yieldStress, 285);
    EXPECT_EQ((part.hardening[1].yieldStress - part.hardening[0].yieldStress)
                  / part.hardening[1].equivalentPlasticStrain,
              900);
}

TEST(PartReader, LetsATableReplaceTheLineOfThePartItIsLike)
{
    const auto parts =
        readParts(Dictionary::parse("parts { a { model elastoplastic; density 1; youngsModulus 10; "
                                    "poissonsRatio 0; yieldStress 5; plasticModulus 1; }"
                                    "b { like a; hardening table ((0 7) (0.1 8)); }"
                                    "c { like a; yieldStress 6; } }"),
                  meshOf({"a", "b", "c"}));

    EXPECT_EQ(parts[1].hardening[0].yieldStress, 7);
    EXPECT_EQ(parts[1].hardening[1].equivalentPlasticStrain, 0.1);
    EXPECT_EQ(parts[2].hardening[1].yieldStress, 7);
}

TEST(PartReader, ChoosesTheHourglassCoefficientByForm)
{
    EXPECT_EQ(readOne(elastic).hourglass, HourglassForm::physical);
    EXPECT_EQ(readOne(elastic).hourglass, Part{}.hourglass);
    EXPECT_EQ(readOne(elastic).hourglassCoefficient, Part{}.hourglassCoefficient);
    EXPECT_EQ(readOne(elastic + "hourglass { form stiffness; }").hourglassCoefficient, 0.05);
    EXPECT_EQ(readOne(elastic + "hourglass { form viscous; }").hourglassCoefficient, 0.1);
    EXPECT_EQ(readOne(elastic + "hourglass { form physical; }").hourglassCoefficient, 1.0);
    EXPECT_EQ(readOne(elastic + "hourglass { coefficient 0.2; }").hourglassCoefficient, 0.2);
}

TEST(PartReader, ReadsHowHourglassForcesAreKept)
{
    EXPECT_EQ(readOne(elastic).hourglassStorage, HourglassStorage::full);
    EXPECT_EQ(readOne(elastic + "hourglass { storage full; }").hourglassStorage,
              HourglassStorage::full);
    EXPECT_EQ(readOne(elastic + "hourglass { storage float; }").hourglassStorage,
              HourglassStorage::float_);
    const std::string text = refusalOf(elastic + "hourglass { storage flaot; }");
    EXPECT_TRUE(contains(text, "storage"));
    EXPECT_TRUE(contains(text, "float"));
    EXPECT_TRUE(contains(text, "full"));
}

TEST(PartReader, NeedsNothingButTheModelOfARigidPart)
{
    EXPECT_EQ(readOne("model rigidPrescribed;").kind, PartKind::rigidPrescribed);
}

TEST(PartReader, RefusesAnEntryWithoutPart)
{
    const std::string text = refusal([] {
        readParts(Dictionary::parse("parts { layr1 { " + elastic + " } }"), meshOf({"layer1"}));
    });

    EXPECT_TRUE(contains(text, "the mesh has no part 'layr1'"));
    EXPECT_TRUE(contains(text, "did you mean 'layer1'?"));
}

TEST(PartReader, RefusesAPartWithoutEntry)
{
    const std::string text = refusal([] {
        readParts(Dictionary::parse("parts { a { " + elastic + " } }"), meshOf({"a", "b"}));
    });

    EXPECT_TRUE(contains(text, "part 'b' of the mesh has no entry"));
    EXPECT_TRUE(contains(text, "b { like a; }"));
}

TEST(PartReader, RefusesPhysicsOutOfRange)
{
    const auto with = [](const std::string& density, const std::string& e, const std::string& nu) {
        return "model elastic; density " + density + "; youngsModulus " + e + "; poissonsRatio "
               + nu + ";";
    };

    EXPECT_TRUE(contains(refusalOf(with("0", "1", "0")), "density"));
    EXPECT_TRUE(contains(refusalOf(with("1", "-1", "0")), "youngsModulus"));
    EXPECT_TRUE(contains(refusalOf(with("1", "1", "0.5")), "poissonsRatio"));
    EXPECT_TRUE(contains(refusalOf(with("1", "1", "-1")), "poissonsRatio"));
}

TEST(PartReader, RefusesPlasticityInARigidPart)
{
    EXPECT_TRUE(contains(refusalOf("model rigidPrescribed; yieldStress 5;"),
                         "no meaning for a rigid part"));
}

TEST(PartReader, RefusesTwoDescriptionsOfTheYieldStress)
{
    EXPECT_TRUE(contains(
        refusalOf(
            "model elastoplastic; density 1; youngsModulus 10; poissonsRatio 0; yieldStress 5; "
            "hardening table ((0 5) (1 6));"),
        "both describe the yield stress"));
}

TEST(PartReader, RefusesATableThatFallsOrStandsStill)
{
    const std::string plastic =
        "model elastoplastic; density 1; youngsModulus 10; poissonsRatio 0;";

    EXPECT_TRUE(contains(refusalOf(plastic + "hardening table ((0 5) (1 4));"), "must not fall"));
    EXPECT_TRUE(contains(refusalOf(plastic + "hardening table ((0 5) (0 6));"), "must ascend"));
    EXPECT_TRUE(contains(refusalOf(plastic + "hardening table ((0.1 5) (0.2 6));"), "strain 0"));
}

TEST(PartReader, RefusesPartsLikeOneAnotherInACircle)
{
    EXPECT_TRUE(contains(refusal([] {
                             readParts(Dictionary::parse("parts { a { like b; } b { like a; } }"),
                                       meshOf({"a", "b"}));
                         }),
                         "goes round in a circle: a, b, a"));
}

TEST(PartReader, SeesWhichPartsAreRigidWithoutTheirMaterials)
{
    const auto rigid = readRigidParts(
        Dictionary::parse(
            "parts { a { model rigidPrescribed; } b { like a; } c { model elastic; } }"),
        meshOf({"a", "b", "c", "d"}));

    EXPECT_EQ(rigid, (std::vector<bool>{true, true, false, false}));
}

TEST(PartReader, ReadsTheRotationAlsoOfThePartItIsLike)
{
    EXPECT_EQ(readOne(elastic).rotation, RotationForm::midSurface);
    EXPECT_EQ(readOne(elastic + "rotation arcsin;").rotation, RotationForm::arcsine);
    EXPECT_EQ(readOne(elastic + "rotation polar;").rotation, RotationForm::polar);
    const auto parts = readParts(
        Dictionary::parse("parts { a { " + elastic + " rotation hughesWinget; } b { like a; } }"),
        meshOf({"a", "b"}));
    EXPECT_EQ(parts[1].rotation, RotationForm::hughesWinget);
    EXPECT_TRUE(contains(refusalOf(elastic + "rotation jaumann;"), "hughesWinget"));
}

TEST(PartReader, ReadsARigidFreePart)
{
    EXPECT_EQ(readOne("model rigidFree; density 2;").kind, PartKind::rigidFree);
    const Part part =
        readOne("model rigidFree; mass 3; centre (1 2 3); inertia (3 4 5 0.1 0.2 0.3);");
    EXPECT_EQ(part.inertia.mass, 3);
    EXPECT_EQ(part.inertia.centre, (Point{1, 2, 3}));
    EXPECT_EQ(part.inertia.inertia[5], 0.3);
}

TEST(PartReader, RefusesARigidFreePartThatNoBodyCouldBe)
{
    EXPECT_TRUE(contains(refusalOf("model rigidFree;"), "is rigidFree, but its mass is not known"));
    EXPECT_TRUE(contains(refusalOf("model rigidFree; mass 1; inertia (1 1 3 0 0 0);"),
                         "no body has this inertia"));
    EXPECT_TRUE(contains(refusalOf("model rigidFree; mass 1; inertia (1 1 1 2 0 0);"),
                         "no body has this inertia"));
    EXPECT_TRUE(contains(refusalOf("model rigidFree; mass 1; inertia (1 1);"),
                         "'inertia' has 2 values, not 6"));
    EXPECT_TRUE(contains(refusalOf("model rigidFree; density 1; centre (0 0 0);"),
                         "'centre' is given without 'inertia'"));
}

TEST(PartReader, ASelectiveHexahedronTurnsByItsSpin)
{
    EXPECT_EQ(readOne(elastic).hexahedron, HexahedronForm::reduced);
    for (const char* rotation : {"", " rotation hughesWinget;"}) {
        const Part part = readOne(elastic + "hexahedron selective;" + rotation);
        EXPECT_EQ(part.hexahedron, HexahedronForm::selective);
        EXPECT_EQ(part.rotation, RotationForm::hughesWinget);
    }
    EXPECT_TRUE(contains(refusalOf(elastic + "hexahedron selective; rotation polar;"),
                         "write: rotation hughesWinget;"));
    EXPECT_TRUE(contains(refusalOf(elastic + "hexahedron full;"), "reduced, selective"));
}
