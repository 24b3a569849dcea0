#include "mesh/Surface.h"
#include "model/ContactLawReader.h"
#include "model/ContactSetup.h"
#include "model/SurfaceReport.h"
#include "model/readModel.h"
#include "support/logFile.h"
#include "unit/model/BoxMesh.h"
#include "unit/model/CaseFolder.h"
#include "unit/model/Refusal.h"

#include <cmath>
#include <limits>

using namespace fpm;
using fpm::test::contains;
using fpm::test::refusal;

namespace {

RigidSurface surfaceOf(const std::string& text)
{
    const Dictionary entry = Dictionary::parse("die { " + text + " }").sub("die");
    RigidSurface surface = readRigidSurface(entry, "die");
    entry.requireAllUsed();
    return surface;
}

ContactLaw lawOf(const std::string& text, bool analytic = false)
{
    const Dictionary entry = Dictionary::parse("pair { " + text + " }").sub("pair");
    ContactLaw law = readContactLaw(entry, analytic);
    entry.requireAllUsed();
    return law;
}

} // namespace

TEST(ContactLawReader, TakesOneCoefficientOrTheWholeLaw)
{
    EXPECT_EQ(lawOf("").friction, 0);
    EXPECT_EQ(lawOf("friction 0.3;").friction, 0.3);
    EXPECT_LT(lawOf("friction 0.3;").dynamicFriction, 0);
    EXPECT_EQ(lawOf("friction { static 0.3; damping 0.1; }").slipDamping, 0.1);
    EXPECT_EQ(lawOf("friction 0.3;").normalDamping, 0.05);
    EXPECT_EQ(lawOf("friction 0.3; normalDamping 0;").normalDamping, 0);
    EXPECT_EQ(lawOf("friction { static 0.3; form paper; }").normalDamping, 0);
    EXPECT_EQ(lawOf("").normalDamping, 0);
    const ContactLaw law = lawOf("friction { static 0.4; dynamic 0.3; decay 2; form paper; }"
                                 "penalty series; normalDamping 0.1; normalScale 0.5;");
    EXPECT_EQ(law.friction, 0.4);
    EXPECT_EQ(law.dynamicFriction, 0.3);
    EXPECT_EQ(law.frictionDecay, 2);
    EXPECT_TRUE(law.paperFriction);
    EXPECT_EQ(law.penalty, PenaltyRule::series);
    EXPECT_EQ(law.normalDamping, 0.1);
    EXPECT_TRUE(contains(refusal([] { lawOf("normalDamping 1.5;"); }), "normalDamping"));
    EXPECT_TRUE(contains(refusal([] { lawOf("friction { dynamic 0.1; decay 1; }"); }), "static"));
}

TEST(ContactLawReader, AnalyticSurfacesAreMetExactlyUnlessSpringsAreAskedFor)
{
    const std::string springs = "enforcement penalty; normalScale 2; normalDamping 0.1; "
                                "friction { static 0.3; form paper; }";
    EXPECT_EQ(lawOf("friction 0.3;", true).enforcement, Enforcement::kinematic);
    EXPECT_EQ(lawOf("enforcement kinematic;", true).enforcement, Enforcement::kinematic);
    EXPECT_EQ(lawOf(springs, true).enforcement, Enforcement::penalty);
    EXPECT_EQ(lawOf("friction 0.3;").enforcement, Enforcement::penalty);
    for (const char* key : {"normalScale 1;", "tangentialScale 1;", "penalty series;",
                            "normalDamping 0.1;", "friction { static 0.3; form paper; }"})
        EXPECT_TRUE(contains(refusal([&] { lawOf(key, true); }), "met exactly")) << key;
    EXPECT_TRUE(contains(refusal([] { lawOf("enforcement kinematic;"); }), "a plane, cylinder"));
}

TEST(RigidSurfaceReader, TakesPlaneCylinderAndSphere)
{
    const RigidSurface plane = surfaceOf("type plane; point (1 2 3); normal (0 0 -2);");
    EXPECT_EQ(plane.axis, (Point{0, 0, -1}));
    EXPECT_EQ(plane.motion, RigidSurface::Motion::none);
    const RigidSurface die =
        surfaceOf("type cylinder; axis ((0 -100 50) (0 100 50)); radius 45; side inside;"
                  "motion { velocity (0 0 -3); amplitude table ((0 0) (1 2)); }");
    EXPECT_EQ(die.length, 200);
    EXPECT_EQ(die.axis, (Point{0, 1, 0}));
    EXPECT_TRUE(die.inside);
    EXPECT_FALSE(die.infinite);
    EXPECT_EQ(die.motion, RigidSurface::Motion::velocity);
    EXPECT_EQ(die.amplitude(1), 2);
    EXPECT_EQ(surfaceOf("type sphere; centre (1 1 1); radius 2;").point, (Point{1, 1, 1}));
    EXPECT_TRUE(
        contains(refusal([] { surfaceOf("type cylinder; axis ((0 0 0) (0 0 0)); radius 1;"); }),
                 "has no length"));
    EXPECT_TRUE(contains(refusal([] { surfaceOf("type cylinder; axis ((0 0 0)); radius 1;"); }),
                         "two ends"));
    EXPECT_TRUE(contains(refusal([] { surfaceOf("type plane; point (0 0 0); normal (0 0 0);"); }),
                         "points nowhere"));
    EXPECT_TRUE(contains(refusal([] {
                             surfaceOf("type plane; point (0 0 0); normal (0 0 1); motion { "
                                       "displacement (0 0 0); velocity (0 0 1); }");
                         }),
                         "both 'displacement' and 'velocity'"));
}

TEST(RigidSurface, TellsGapAndNormalBeforeTheRun)
{
    Point n{};
    const RigidSurface pipe =
        surfaceOf("type cylinder; axis ((0 0 0) (0 0 10)); radius 5; side inside;");
    EXPECT_NEAR(pipe.gap({3, 0, 1}, n), 2, 1e-15);
    EXPECT_EQ(n, (Point{-1, 0, 0}));
    EXPECT_EQ(pipe.gap({3, 0, 11}, n), std::numeric_limits<double>::infinity());
    const RigidSurface ball = surfaceOf("type sphere; centre (1 0 0); radius 2;");
    EXPECT_NEAR(ball.gap({1, 1, 0}, n), -1, 1e-15);
    EXPECT_EQ(n, (Point{0, 1, 0}));
}

TEST(ContactSetup, AcceptsAnAnalyticTargetAndReportsHowTheBodyLies)
{
    const test::CaseFolder folder;
    const std::string contactDict =
        "pairs { onWall { contactor box; target wall; } }"
        "surfaces { wall { type plane; point (0 0 -0.5); normal (0 0 1); } }";
    folder.write("system/contactDict", contactDict);
    folder.write("constant/partProperties", "parts { box { model elastic; density 7.85e-9; "
                                            "youngsModulus 210000; poissonsRatio 0.3; } }");
    Mesh mesh = test::boxMesh({{"box", {0, 0, 0}, {2, 2, 2}, {2, 2, 2}}});
    {
        Log log = test::logInto(folder.logFile());
        setContact(mesh, folder.open().dictionary("system/contactDict"), folder.open(), log);
    }
    EXPECT_TRUE(contains(folder.logText(), "pair onWall: 26 contactor nodes (area 24), target: "
                                           "analytic plane wall"));
    EXPECT_TRUE(contains(folder.logText(),
                         "initial gap: smallest 0.5, mean 0.5 over 9 nodes that face the target"));
    folder.write(mesh);
    EXPECT_FALSE(contactIsOutdated(folder.mesh(), folder.open()));
    Log quiet = Log::quiet();
    const Model model = readModel(folder.open(), quiet);
    ASSERT_EQ(model.rigidSurfaces.size(), 1u);
    EXPECT_EQ(model.contactPairs[0].surface, 0);
    EXPECT_TRUE(model.contactPairs[0].targetSides.empty());

    for (const auto& [option, why] :
         {std::pair{"passes two;", "no nodes for a second pass"},
          std::pair{"search closestParticle;", "no particles to search"},
          std::pair{"projection cold;", "no faces to project on"},
          std::pair{"edges yes;", "the target has no edges"},
          std::pair{"initialOverlap move;", "only overlaps with faces"}}) {
        folder.write("system/contactDict",
                     std::string("pairs { onWall { contactor box; target wall; ") + option
                         + " } } surfaces { wall { type plane; point (0 0 0); normal (0 0 1); } }");
        EXPECT_TRUE(contains(refusal([&] {
                                 setContact(mesh, folder.open().dictionary("system/contactDict"),
                                            folder.open(), quiet);
                             }),
                             why));
    }

    const SurfaceFit deep = measureSurfaceContact(
        mesh, mesh.contact[0], surfaceOf("type sphere; centre (1 1 -1); radius 1.25;"));
    EXPECT_EQ(deep.overlaps, 1u); // the middle of the lower side
    EXPECT_NEAR(deep.deepest, 0.25, 1e-12);
    EXPECT_EQ(deep.facingNodes, 8u);
    EXPECT_NEAR(deep.smallestGap, std::sqrt(2.0) - 1.25, 1e-12);
}
