#include "model/readModel.h"

#include "model/ContactSetup.h"
#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::string contactDict =
    "pairs { strike { contactor rod; target plate1; friction 0.2; normalScale 2; } }";

/// A complete case: a rod falls on two plates.
void writeCase(const test::CaseFolder& folder)
{
    folder.write("constant/partProperties",
                 "parts { rod { model elastic; density 7.85e-9; youngsModulus 210000; "
                 "poissonsRatio 0.3; } plate1 { like rod; } plate2 { like rod; } "
                 "die { model rigidPrescribed; } }");
    folder.write("constant/boundaryConditions",
                 "edges { type fixed; set plateEdges; } die { type fixed; part die; }");
    folder.write("0/initialConditions", "fall { type velocity; part rod; value (0 0 -100); }");
    folder.write("system/contactDict", contactDict);
    Mesh mesh = test::rodAndPlates();
    Log log = Log::quiet();
    setContact(mesh, Dictionary::parse(contactDict), folder.open(), log);
    folder.write(mesh);
}

Model read(const test::CaseFolder& folder)
{
    Log log = test::logInto(folder.logFile());
    return readModel(folder.open(), log);
}

} // namespace

TEST(ReadModel, BringsTheWholeCaseTogether)
{
    const test::CaseFolder folder;
    writeCase(folder);

    const Model model = read(folder);

    EXPECT_EQ(model.parts.size(), model.mesh.parts.size());
    EXPECT_EQ(model.parts[3].kind, PartKind::rigidPrescribed);
    EXPECT_EQ(model.boundaryConditions.size(), 2u);
    EXPECT_EQ(model.initialVelocities[0].nodes.size(), 45u);
    ASSERT_EQ(model.contactPairs.size(), 1u);
    EXPECT_EQ(model.contactPairs[0].friction, 0.2);
    EXPECT_EQ(model.contactPairs[0].normalScale, 2);
    EXPECT_EQ(model.contactPairs[0].contactorNodes, model.mesh.contact[0].contactorNodes);
    EXPECT_EQ(model.control.endTime, 1e-4);
    EXPECT_TRUE(contains(folder.logText(), "part rod: elastic, 16 elements"));
}

TEST(ReadModel, NeedsNeitherConditionsNorContact)
{
    const test::CaseFolder folder;
    folder.write(test::boxMesh({{"rod", {0, 0, 0}, {1, 1, 1}}}));
    folder.write("constant/partProperties", "parts { rod { model elastic; density 7.85e-9; "
                                            "youngsModulus 210000; poissonsRatio 0.3; } }");

    const Model model = read(folder);

    EXPECT_TRUE(model.boundaryConditions.empty());
    EXPECT_TRUE(model.initialVelocities.empty());
    EXPECT_TRUE(model.contactPairs.empty());
}

TEST(ReadModel, RefusesContactSurfacesOfAnotherContactDict)
{
    const test::CaseFolder folder;
    writeCase(folder);
    folder.write("system/contactDict", "pairs { strike { contactor rod; target plate2; } }");

    const std::string text = refusal([&] { read(folder); });

    EXPECT_TRUE(contains(text, "were not made from this system/contactDict"));
    EXPECT_TRUE(contains(text, "run fpmSetContact"));
}

TEST(ReadModel, RefusesAPairWhosePartsBecameRigid)
{
    const test::CaseFolder folder;
    writeCase(folder);
    folder.write("constant/partProperties",
                 "parts { rod { model rigidPrescribed; } plate1 { like rod; } plate2 { like rod; } "
                 "die { model rigidPrescribed; } }");
    folder.write("constant/boundaryConditions",
                 "a { type fixed; part rod; } b { type fixed; part plate1; }"
                 "c { type fixed; part plate2; } d { type fixed; part die; }");

    folder.write("0/initialConditions", "");

    EXPECT_TRUE(contains(refusal([&] { read(folder); }), "are both rigid"));
}

TEST(ReadModel, RefusesFreeRigidPartsWithoutATimeStep)
{
    const test::CaseFolder folder;
    writeCase(folder);
    folder.write("constant/partProperties",
                 "parts { rod { model rigidFree; density 1; } plate1 { model rigidPrescribed; } "
                 "plate2 { like plate1; } die { like plate1; } }");
    folder.write("constant/boundaryConditions",
                 "a { type fixed; part plate1; } b { type fixed; part plate2; }"
                 "c { type fixed; part die; }");

    EXPECT_TRUE(contains(refusal([&] { read(folder); }),
                         "all parts are rigid: nothing limits the time step"));
}
