#include "model/ContactSetup.h"

#include "mesh/Surface.h"
#include "model/ContactReport.h"
#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

#include <chrono>

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

const std::string onePair = "pairs { press { contactor upper; target lower; } }";

/// An upper block of side 2 over the middle of a lower one of side 4, `gap` apart.
Mesh blocks(double gap)
{
    return test::boxMesh({{"lower", {0, 0, 0}, {4, 4, 1}, {4, 4, 2}},
                          {"upper", {1, 1, 1 + gap}, {2, 2, 1}, {3, 3, 1}}});
}

struct Workshop {
    test::CaseFolder folder;
    Mesh mesh;

    explicit Workshop(Mesh start) : mesh(std::move(start)) {}
    void run(const std::string& contactDict)
    {
        folder.write("system/contactDict", contactDict);
        Log log = test::logInto(folder.logFile());
        setContact(mesh, folder.open().dictionary("system/contactDict"), folder.open(), log);
    }
};

ContactFit fitOf(const Mesh& mesh)
{
    ContactSurfaces surfaces{"press", {}, skin(mesh, 1), skin(mesh, 0)};
    surfaces.contactorNodes = nodesOf(mesh, surfaces.contactorSides);
    return measureContact(mesh, surfaces);
}

} // namespace

TEST(ContactSetup, StoresBothSidesOfThePairInTheMesh)
{
    Workshop shop(blocks(0.1));

    shop.run(onePair);

    ASSERT_EQ(shop.mesh.contact.size(), 1u);
    const ContactSurfaces& surfaces = shop.mesh.contact.front();
    EXPECT_EQ(surfaces.pair, "press");
    EXPECT_EQ(surfaces.contactorNodes.size(), 32u);
    EXPECT_EQ(surfaces.contactorSides, skin(shop.mesh, 1));
    EXPECT_EQ(surfaces.targetSides, skin(shop.mesh, 0));
    EXPECT_TRUE(contains(shop.folder.logText(),
                         "pair press: 32 contactor nodes (area 16), 64 target faces (area 48)"));
}

TEST(ContactSetup, WhatOnlyTheSecondPassSeesIsNoWarningWithTwoAndHasItsCureWithOne)
{
    // No node of the coarse lower block lies under the punch.
    const Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {12, 12, 6}, {3, 3, 3}},
                                     {"upper", {4.5, 4.5, 6.05}, {3, 3, 6}, {6, 6, 12}}});
    Workshop two(mesh), one(mesh),
        away(test::boxMesh({{"lower", {0, 0, 0}, {4, 4, 1}, {4, 4, 2}},
                            {"upper", {10, 1, 2}, {2, 2, 1}, {3, 3, 1}}}));

    two.run("pairs { press { contactor lower; target upper; passes two; } }");
    one.run("pairs { press { contactor lower; target upper; } }");
    away.run("pairs { press { contactor lower.zMax; target upper.xMin; } }");

    EXPECT_FALSE(contains(two.folder.logText(), "warning"));
    EXPECT_TRUE(contains(two.folder.logText(), "its second pass meets: 49 nodes"));
    EXPECT_TRUE(contains(one.folder.logText(), "but 49 nodes of the target face the contactor: "
                                               "swap contactor and target, or set passes two"));
    EXPECT_TRUE(
        contains(away.folder.logText(), "are contactor and target the surfaces that meet?"));
}

TEST(ContactSetup, MeasuresTheGapOfTheNodesThatFaceTheTarget)
{
    const ContactFit fit = fitOf(blocks(0.25));

    EXPECT_EQ(fit.facingNodes, 16u);
    EXPECT_NEAR(fit.smallestGap, 0.25, 1e-12);
    EXPECT_NEAR(fit.meanGap, 0.25, 1e-12);
    EXPECT_TRUE(fit.depths.none());
    EXPECT_EQ(fit.facesPointingAway, 0u);
}

TEST(ContactSetup, TakesTouchingBodiesForTouching)
{
    for (const double gap : {0.0, 1e-12, -1e-12}) {
        const ContactFit fit = fitOf(blocks(gap));
        EXPECT_TRUE(fit.depths.none());
        EXPECT_EQ(fit.smallestGap, 0.0);
    }
}

TEST(ContactSetup, SeesThatANodeOnTheRimOfTheTargetFacesItsTop)
{
    // The upper block stands on a corner of the lower one, five of its lower nodes on the rim.
    const Mesh mesh = test::boxMesh(
        {{"lower", {0, 0, 0}, {4, 4, 1}, {4, 4, 2}}, {"upper", {0, 0, 1}, {2, 2, 1}, {2, 2, 1}}});

    EXPECT_EQ(fitOf(mesh).facingNodes, 9u);
}

TEST(ContactSetup, CountsOverlapsAndTheirDepth)
{
    Workshop shop(blocks(-0.125));

    shop.run(onePair);

    const ContactFit fit = fitOf(shop.mesh);
    ASSERT_EQ(fit.depths.held.size(), 16u);
    for (const InitialDepths::Node& inside : fit.depths.held)
        EXPECT_NEAR(inside.depth, 0.125, 1e-12);
    EXPECT_TRUE(
        contains(shop.folder.logText(),
                 "warning: pair press: 16 contactor nodes lie inside the target, deepest 0.125"));
}

TEST(ContactSetup, RefusesATargetThatIsTurnedAway)
{
    // F10: with its normals away from the contactors, a target would draw them in.
    Workshop shop(blocks(0.25));

    EXPECT_TRUE(contains(
        refusal([&] { shop.run("pairs { press { contactor upper.zMin; target lower.zMin; } }"); }),
        "all contactor nodes lie behind the target, 9 of its faces point away"));
}

TEST(ContactSetup, KnowsWhenItsSurfacesAreOutOfDate)
{
    Workshop shop(blocks(0.1));
    EXPECT_FALSE(contactIsOutdated(shop.mesh, shop.folder.open()));

    shop.folder.write("system/contactDict", onePair);
    EXPECT_TRUE(contactIsOutdated(shop.mesh, shop.folder.open()));
    shop.run(onePair);
    EXPECT_FALSE(contactIsOutdated(shop.mesh, shop.folder.open()));

    shop.folder.write("system/contactDict",
                      "// friction leaves the surfaces as they are\n"
                      "pairs { press { target lower; contactor upper; friction 0.2; } }");
    EXPECT_FALSE(contactIsOutdated(shop.mesh, shop.folder.open()));
    shop.folder.write("system/contactDict",
                      "pairs { press { contactor upper; target lower.zMax; } }");
    EXPECT_TRUE(contactIsOutdated(shop.mesh, shop.folder.open()));

    shop.folder.write("system/contactDict", onePair);
    shop.mesh.points[0][0] -= 1e-3;
    EXPECT_TRUE(contactIsOutdated(shop.mesh, shop.folder.open()));
}

TEST(ContactSetup, RefusesAPairOfRigidParts)
{
    Workshop shop(blocks(0.1));
    shop.folder.write("constant/partProperties",
                      "parts { upper { model rigidPrescribed; } lower { like upper; } }");

    EXPECT_TRUE(
        contains(refusal([&] { shop.run(onePair); }),
                 "parts 'upper' and 'lower' are both rigid: no mass limits the contact force"));
}

TEST(ContactSetup, RefusesANodeThatIsItsOwnTarget)
{
    Workshop shop(blocks(0.1));

    EXPECT_TRUE(contains(
        refusal([&] { shop.run("pairs { own { contactor upper; target upper.zMin; } }"); }),
        "16 nodes are contactor and target at once"));
    EXPECT_TRUE(shop.mesh.contact.empty());
}

TEST(ContactSetup, TakesASurfaceAgainstItself)
{
    Workshop shop(blocks(0.1));

    shop.run("pairs { own { contactor upper; target upper; } }");

    EXPECT_EQ(shop.mesh.contact[0].contactorSides, shop.mesh.contact[0].targetSides);
    EXPECT_TRUE(contains(refusal([&] {
                             shop.run("pairs { own { contactor upper; target upper; "
                                      "search closestParticle; } }");
                         }),
                         "needs the search by faces"));
    EXPECT_TRUE(contains(
        refusal([&] { shop.run("pairs { own { contactor upper; target upper; passes two; } }"); }),
        "has one pass"));
    EXPECT_TRUE(contains(refusal([&] {
                             shop.run("pairs { own { contactor upper; target upper; "
                                      "initialOverlap move; } }");
                         }),
                         "nothing says which side should move"));
}

TEST(ContactSetup, GeneralContactIsAllFacesOfAllParts)
{
    Workshop shop(blocks(-0.125));

    shop.run("general;");

    ASSERT_EQ(shop.mesh.contact.size(), 1u);
    EXPECT_EQ(shop.mesh.contact[0].pair, "general");
    EXPECT_EQ(shop.mesh.contact[0].targetSides.size(),
              skin(shop.mesh, 0).size() + skin(shop.mesh, 1).size());
    EXPECT_TRUE(
        contains(shop.folder.logText(), "pair upper in lower: 16 contactor nodes lie inside"));
    EXPECT_FALSE(contactIsOutdated(shop.mesh, shop.folder.open()));

    shop.run("general { friction 0.2; } pairs { press { contactor upper; target lower; } }");
    EXPECT_EQ(shop.mesh.contact.size(), 2u);
}

TEST(ContactSetup, RefusesWrongGeneralContact)
{
    Workshop shop(blocks(0.1));

    EXPECT_TRUE(
        contains(refusal([&] { shop.run("general yes;"); }), "general contact has no value"));
    EXPECT_TRUE(contains(refusal([&] { shop.run("general { initialOverlap move; }"); }),
                         "nothing says which body should move"));
    EXPECT_TRUE(
        contains(refusal([&] { shop.run("pairs { general { contactor upper; target lower; } }"); }),
                 "'general' is the name of contact of all bodies with all"));
    EXPECT_TRUE(contains(refusal([&] { shop.run("general { passes two; }"); }), "unknown keyword"));
    EXPECT_TRUE(contains(refusal([&] { shop.run("general { edges some; }"); }), "edges"));
}

TEST(ContactSetup, TellsTheSharpEdgesThatMayMeet)
{
    Workshop shop(blocks(0.1));
    const auto edgesIn = [&](const std::string& contactDict) {
        shop.run(contactDict);
        return shop.folder.logText();
    };
    // Along the twelve edges of boxes of 4 x 4 x 2 and of 3 x 3 x 1 elements.
    EXPECT_TRUE(contains(edgesIn("general;"), "68 segments of sharp edges"));
    EXPECT_FALSE(contains(edgesIn("general { edges no; }"), "sharp edges"));
    EXPECT_FALSE(contains(edgesIn(onePair), "sharp edges"));
    EXPECT_TRUE(contains(edgesIn("pairs { press { contactor upper; target lower; edges yes; } }"),
                         "28 segments of sharp edges against 40"));
}

TEST(ContactSetup, MovesOverlapsToTheSurfaceOnRequest)
{
    // F11, option move: the nodes lie on the target then, and nothing is left to report.
    Workshop shop(blocks(-0.125));

    shop.run("pairs { press { contactor upper; target lower; initialOverlap move; } }");

    EXPECT_TRUE(contains(shop.folder.logText(), "16 nodes moved, by at most 0.125"));
    EXPECT_TRUE(fitOf(shop.mesh).depths.none());
    EXPECT_FALSE(contactIsOutdated(shop.mesh, shop.folder.open()));
    EXPECT_TRUE(contains(refusal([&] {
                             Workshop deep(blocks(-0.45));
                             for (Point& p : deep.mesh.points)
                                 if (p[2] > 1.5) p[2] -= 0.7; // the upper block 0.3 thick
                             deep.run("pairs { press { contactor upper.zMin; target lower; "
                                      "initialOverlap move; } }");
                         }),
                         "inside out"));
}

TEST(ContactSetup, RefusesARampWithoutATime)
{
    Workshop shop(blocks(0.1));

    EXPECT_TRUE(contains(refusal([&] {
                             shop.run("pairs { press { contactor upper; target lower; "
                                      "initialOverlap ramp; } }");
                         }),
                         "rampTime"));
    EXPECT_TRUE(contains(refusal([&] {
                             shop.run("pairs { press { contactor upper; target lower; "
                                      "initialOverlap push; } }");
                         }),
                         "report"));
    EXPECT_TRUE(contains(refusal([&] {
                             shop.run("pairs { press { contactor upper; target lower; "
                                      "passes three; } }");
                         }),
                         "two"));
}

TEST(ContactSetup, WarnsOfSeamsInTheTarget)
{
    // F23: two halves of one part that touch without sharing their nodes.
    Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {2, 4, 1}, {2, 4, 1}},
                               {"half", {2, 0, 0}, {2, 4, 1}, {2, 4, 1}},
                               {"upper", {1, 1, 1.1}, {2, 2, 1}, {3, 3, 1}}});
    mesh.sideSets["top"] = mesh.sideSets["lower.zMax"];
    for (const ElementSide& side : mesh.sideSets["half.zMax"]) mesh.sideSets["top"].push_back(side);
    Workshop shop(mesh);

    shop.run("pairs { press { contactor upper; target top; } }");

    EXPECT_TRUE(contains(shop.folder.logText(),
                         "pair press: 10 target nodes lie on one another without being one"));
}

TEST(ContactSetup, BodiesThatTouchNodeOnNodeAreNoSeam)
{
    Workshop shop(test::boxMesh(
        {{"lower", {0, 0, 0}, {2, 2, 1}, {2, 2, 1}}, {"upper", {0, 0, 1}, {2, 2, 1}, {2, 2, 1}}}));

    shop.run("general;");

    EXPECT_FALSE(contains(shop.folder.logText(), "lie on one another"));
}

TEST(ContactSetup, WarnsOfPairsThatActTwice)
{
    Workshop shop(blocks(0.1));

    shop.run("pairs { a { contactor upper; target lower; }"
             "b { contactor upper.zMin; target lower.zMax; } }");

    EXPECT_TRUE(contains(shop.folder.logText(),
                         "warning: pairs a and b share 16 contactor nodes and 16 target faces"));
}

TEST(ContactSetup, MeasuresAHundredThousandFacesInSeconds)
{
    const Mesh mesh = test::boxMesh({{"lower", {0, 0, 0}, {100, 100, 1}, {220, 220, 1}},
                                     {"upper", {0, 0, 1.5}, {100, 100, 50}, {100, 100, 5}}});
    const auto start = std::chrono::steady_clock::now();

    const ContactFit fit = fitOf(mesh);

    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_NEAR(fit.smallestGap, 0.5, 1e-12);
    EXPECT_LT(seconds.count(), 20);
    RecordProperty("seconds", std::to_string(seconds.count()));
}
