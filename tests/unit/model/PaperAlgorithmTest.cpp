#include "model/PaperAlgorithm.h"

#include "model/ContactSetup.h"
#include "model/readModel.h"
#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::string steel = "density 7.85e-9; youngsModulus 210000; poissonsRatio 0.3;";

/// A rod falls on two plates; `rod`: further entries of its part, `strike` of its pair.
struct RodCase {
    test::CaseFolder folder;
    RodCase(const std::string& control,
            const std::string& rod = "",
            const std::string& strike = "contactor rod; target plate1;")
    {
        const std::string contactDict = "pairs { strike { " + strike + " } }";
        folder.write("constant/partProperties",
                     "parts { rod { model elastic; " + steel + rod + " } plate1 { model elastic; "
                         + steel + " } plate2 { like plate1; } die { model rigidPrescribed; } }");
        folder.write("constant/boundaryConditions",
                     "edges { type fixed; set plateEdges; } die { type fixed; part die; }");
        folder.write("system/contactDict", contactDict);
        folder.write("system/controlDict", "endTime 1e-4; " + control);
        Mesh mesh = test::rodAndPlates();
        Log log = Log::quiet();
        setContact(mesh, Dictionary::parse(contactDict), folder.open(), log);
        folder.write(mesh);
    }
    Model read() const
    {
        Log log = test::logInto(folder.logFile());
        return readModel(folder.open(), log);
    }
};

} // namespace

TEST(PaperAlgorithm, IsChosenForAllPartsAndPairsAtOnce)
{
    const RodCase plain(""),
        paper("algorithm paper;", "", "contactor rod; target plate1; friction 0.2;");
    EXPECT_FALSE(plain.read().control.paperAlgorithm);
    EXPECT_EQ(plain.read().contactPairs[0].projection, ContactProjection::tracked);
    const Model model = paper.read();
    for (std::size_t part = 0; part < 3; ++part)
        EXPECT_EQ(model.parts[part].rotation, RotationForm::arcsine);
    EXPECT_FALSE(model.control.midStepStrain);
    EXPECT_EQ(model.contactPairs[0].search, ContactSearch::closestParticle);
    EXPECT_EQ(model.contactPairs[0].projection, ContactProjection::cold);
    EXPECT_TRUE(model.contactPairs[0].paperFriction);
    EXPECT_FALSE(contains(paper.folder.logText(), "overrides"));
}

TEST(PaperAlgorithm, SaysWhatItOverrides)
{
    const RodCase paper("algorithm paper; strainGeometry midStep;", "rotation polar;",
                        "contactor rod; target plate1; search faces; projection tracked;");
    EXPECT_EQ(paper.read().parts[0].rotation, RotationForm::arcsine);
    for (const char* what : {"rotation of part rod", "strainGeometry", "search of pair strike",
                             "projection of pair strike"})
        EXPECT_TRUE(contains(paper.folder.logText(), std::string("overrides ") + what)) << what;
    EXPECT_FALSE(contains(paper.folder.logText(), "rotation of part plate1"));

    const RodCase same("algorithm paper; strainGeometry start;", "rotation arcsin;",
                       "contactor rod; target plate1; search closestParticle; projection cold;");
    same.read();
    EXPECT_FALSE(contains(same.folder.logText(), "overrides"));
}

TEST(PaperAlgorithm, RefusesWhatThePaperLacks)
{
    EXPECT_TRUE(
        contains(refusal([] { RodCase("algorithm paper;", "hexahedron selective;").read(); }),
                 "part 'rod' has hexahedron selective"));
    EXPECT_TRUE(contains(
        refusal([] { RodCase("algorithm paper;", "", "contactor rod; target rod;").read(); }),
        "'strike' is contact of surfaces with themselves"));
    EXPECT_TRUE(
        contains(refusal([] { RodCase("algorithm papr;").read(); }), "'algorithm' must be"));
}

TEST(PaperAlgorithm, EachOfItsChoicesCanBeMadeAlone)
{
    const RodCase cold("", "rotation arcsin;", "contactor rod; target plate1; projection cold;");
    const Model model = cold.read();
    EXPECT_EQ(model.parts[0].rotation, RotationForm::arcsine);
    EXPECT_EQ(model.parts[1].rotation, RotationForm::midSurface);
    EXPECT_EQ(model.contactPairs[0].search, ContactSearch::faces);
    EXPECT_EQ(model.contactPairs[0].projection, ContactProjection::cold);
}
