#include "model/MotionCheck.h"

#include "model/BoundaryReader.h"
#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

Model modelOf(const Dictionary& boundary, const std::string& initial, PartKind kind)
{
    Model model;
    model.mesh = test::boxMesh({{"block", {0, 0, 0}, {1, 1, 1}}});
    model.parts.resize(1);
    model.parts[0].name = "block";
    model.parts[0].kind = kind;
    model.boundaryConditions = readBoundaryConditions(boundary, model.mesh);
    model.initialVelocities = readInitialVelocities(Dictionary::parse(initial), model.mesh);
    return model;
}

void check(const std::string& conditions, PartKind kind = PartKind::elastic)
{
    const auto boundary = Dictionary::parse(conditions, "constant/boundaryConditions");
    Log log = Log::quiet();
    checkMotions(modelOf(boundary, "", kind), boundary, log);
}

} // namespace

TEST(MotionCheck, AcceptsConditionsThatMeetButAgree)
{
    EXPECT_NO_THROW(check("a { type fixed; set block.xMin; }"
                          "b { type fixed; set block.yMin; }"
                          "c { type velocity; set block.zMin; value (0 0 0); }"));
    EXPECT_NO_THROW(check("a { type symmetry; set block.xMin; normal x; }"
                          "b { type velocity; set block.zMax; value (0 0 5); components (z); }"));
}

TEST(MotionCheck, RefusesANodeHeldByOneConditionAndDrivenByAnother)
{
    const std::string text = refusal([] {
        check("edges { type fixed; set block.xMin; }"
              "pull { type velocity; set block.zMax; value (0 0 5); components (z); }");
    });

    EXPECT_TRUE(contains(text, "component z of node 4 at (0 0 1) is held by 'edges'"));
    EXPECT_TRUE(contains(text, "driven otherwise by 'pull' (2 such nodes)"));
}

TEST(MotionCheck, RefusesTwoDriversOfDifferentValueOrAmplitude)
{
    const std::string first = "a { type velocity; part block; value (0 0 5); }";

    EXPECT_NO_THROW(check(first + "b { type velocity; set block.zMax; value (0 0 5); }"));
    EXPECT_TRUE(contains(
        refusal([&] { check(first + "b { type velocity; set block.zMax; value (0 0 6); }"); }),
        "4 such nodes"));
    EXPECT_TRUE(contains(refusal([&] {
                             check(first
                                   + "b { type velocity; set block.zMax; value (0 0 5);"
                                     "amplitude table ((0 0) (1 1)); }");
                         }),
                         "driven otherwise by 'b'"));
}

TEST(MotionCheck, AcceptsARigidPartThatIsPrescribedThroughout)
{
    EXPECT_NO_THROW(
        check("die { type velocity; part block; value (0 0 5); }", PartKind::rigidPrescribed));
}

TEST(MotionCheck, RefusesARigidPartThatIsFreeSomewhere)
{
    const std::string text = refusal([] {
        check("die { type velocity; part block; value (0 0 5); components (x z); }",
              PartKind::rigidPrescribed);
    });

    EXPECT_TRUE(contains(
        text, "part 'block' is rigidPrescribed, but component y of its node 0 at (0 0 0) is "
              "neither held nor driven"));
    EXPECT_TRUE(contains(text, "it moves only as prescribed"));
}

TEST(MotionCheck, RefusesARigidPartThatWouldChangeItsShape)
{
    EXPECT_TRUE(contains(refusal([] {
                             check("top { type velocity; set block.zMax; value (0 0 5); }"
                                   "bottom { type fixed; set block.zMin; }",
                                   PartKind::rigidPrescribed);
                         }),
                         "its nodes are moved differently in component z by 'bottom' and 'top'"));
}

TEST(MotionCheck, TellsWhereAnInitialVelocityHasNoEffect)
{
    const test::CaseFolder folder;
    const auto boundary = Dictionary::parse("edges { type fixed; set block.zMin; }");
    {
        Log log = test::logInto(folder.logFile());
        checkMotions(modelOf(boundary, "fall { type velocity; part block; value (0 0 -3); }",
                             PartKind::elastic),
                     boundary, log);
    }

    EXPECT_TRUE(contains(folder.logText(),
                         "initial velocity 'fall': component z has no effect at 4 of its 8 nodes"));
}

TEST(MotionCheck, AcceptsMirrorPlanesOfDifferentNormalsThatMeet)
{
    EXPECT_NO_THROW(check("a { type symmetry; set block.xMin; normal x; }"
                          "b { type symmetry; set block.yMin; normal (1 -1 0); }"));
    EXPECT_NO_THROW(check("a { type symmetry; set block.xMin; normal (1 1 0); }"
                          "b { type velocity; set block.zMin; value (0 0 5); components (z); }"));
}

TEST(MotionCheck, RefusesADriveThatLeansOnWhatIsHeld)
{
    EXPECT_TRUE(
        contains(refusal([] {
                     check("a { type symmetry; set block.xMin; normal (1 1 0); }"
                           "b { type velocity; set block.zMin; value (5 0 0); components (x); }");
                 }),
                 "of node 0 at (0 0 0) is neither along nor across what 'b' imposes there (2 such "
                 "nodes)"));
    EXPECT_TRUE(contains(refusal([] {
                             check("a { type fixed; set block.xMin; components (x);"
                                   "axes ((1 1 0) (-1 1 0)); }"
                                   "b { type velocity; set block.zMin; value (5 0 0); "
                                   "components (x); axes ((1 1 0) (-1 1 0)); }");
                         }),
                         "driven otherwise by 'b' (2 such nodes)"));
}

TEST(MotionCheck, AcceptsARigidPartTurnedByARotation)
{
    const std::string turn = "turn { type rotation; part block; axis (0 0 1); centre (0 0 0); "
                             "angle 30; amplitude smooth ((0 0) (1 1)); }";
    EXPECT_NO_THROW(check(turn, PartKind::rigidPrescribed));
    EXPECT_TRUE(contains(refusal([&] {
                             check(turn + "b { type fixed; set block.zMax; }",
                                   PartKind::rigidPrescribed);
                         }),
                         "component x of node 4 at (0 0 1) is driven by 'turn' but held otherwise "
                         "by 'b'"));
}

TEST(MotionCheck, HoldsARigidFreePartAsAWholeOnly)
{
    const auto free = PartKind::rigidFree;
    EXPECT_NO_THROW(check("", free));
    EXPECT_NO_THROW(check("a { type fixed; part block; components (x); rotations (y z); }"
                          "b { type force; set block.zMax; value (0 0 1); }",
                          free));
    EXPECT_NO_THROW(check("a { type symmetry; part block; normal (1 1 0); }", free));
    EXPECT_TRUE(contains(refusal([&] { check("a { type fixed; set block.zMax; }", free); }),
                         "'a' holds node 4 at (0 0 1) of part 'block', which is rigidFree and "
                         "moves as a whole"));
    EXPECT_TRUE(
        contains(refusal([&] { check("a { type velocity; part block; value (0 0 1); }", free); }),
                 "'a' drives part 'block', which is rigidFree"));
    EXPECT_TRUE(
        contains(refusal([&] { check("a { type fixed; part block; rotations (x); }", free); }),
                 "one rotation of part 'block' is held and two are free"));
    for (const char* components : {"", "components (x y z);"})
        EXPECT_TRUE(contains(refusal([&] {
                                 check(std::string("a { type fixed; part block; rotations (x); ")
                                       + components + " }");
                             }),
                             "'a' holds rotations, but does not name a rigidFree part"));
}

TEST(MotionCheck, RefusesNodesSharedWithARigidFreePart)
{
    const auto boundary = Dictionary::parse("");
    Model model = modelOf(boundary, "", PartKind::rigidFree);
    model.mesh.parts.push_back({"skin", 1, 1});
    model.mesh.hexahedra.push_back(model.mesh.hexahedra.front());
    model.parts.resize(2);
    model.parts[1].name = "skin";
    Log log = Log::quiet();
    EXPECT_TRUE(contains(refusal([&] { checkMotions(model, boundary, log); }),
                         "parts 'block' and 'skin' share node 0 at (0 0 0)"));
}

TEST(MotionCheck, RefusesInitialVelocitiesOfSingleNodesOfARigidFreePart)
{
    const auto boundary = Dictionary::parse("");
    Log log = Log::quiet();
    EXPECT_TRUE(contains(refusal([&] {
                             checkMotions(modelOf(boundary,
                                                  "a { type velocity; set block.zMax; "
                                                  "value (0 0 1); }",
                                                  PartKind::rigidFree),
                                          boundary, log);
                         }),
                         "'a' gives a velocity to single nodes of part 'block'"));
}
