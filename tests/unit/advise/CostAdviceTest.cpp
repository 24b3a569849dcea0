#include "advise/CostAdvice.h"

#include "advise/Trial.h"
#include "unit/advise/symmetricScene.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

bool says(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// symmetricScene, whose upper block yields, with what a run of it may have left.
struct CostAdviceTest : testing::Test {
    CostAdviceTest()
    {
        results.parts.resize(2);
        results.parts[1].plasticStrain = 0.01;
        results.steps = StepFigures{1000, 1e-4, 2e-7, "contact pair touch: node 3"};
    }
    Model model = symmetricScene();
    Results results;
};

} // namespace

TEST_F(CostAdviceTest, AnElasticHourglassStiffnessIsWrongWhereThePartYields)
{
    model.parts[1].hardening = {{0, 285}, {1, 1185}};
    const auto advice = hourglassAdvice(model, results);
    ASSERT_TRUE(advice);
    EXPECT_EQ(advice->subject, "part upper: hourglass form physical, plastic coupled");
    ASSERT_EQ(advice->edits.changes.size(), 3u);
    EXPECT_EQ(advice->edits.changes[0].path, "parts.upper.hourglass.form");
    EXPECT_TRUE(hourglassAdvice(model, {})) << "without results it may yield";
    results.parts[1].plasticStrain = 0;
    EXPECT_FALSE(hourglassAdvice(model, results)) << "it has not yielded";

    results.parts[1].plasticStrain = 0.01;
    Part& part = model.parts[1];
    part.hourglass = HourglassForm::physical;
    part.hourglassPlastic = HourglassPlastic::coupled;
    EXPECT_FALSE(hourglassAdvice(model, results));
    part.hourglassPlastic = HourglassPlastic::elastic;
    EXPECT_TRUE(hourglassAdvice(model, results));
    part.hexahedron = HexahedronForm::selective;
    EXPECT_FALSE(hourglassAdvice(model, results)) << "eight points have none";
    part.hexahedron = HexahedronForm::reduced;
    part.hourglass = HourglassForm::viscous;
    EXPECT_FALSE(hourglassAdvice(model, results));
}

TEST_F(CostAdviceTest, ContactSpringsThatMakeTheStepShortAreNamed)
{
    // 1e-4 in steps of 0.9 times 2e-7: 556. The run made 1000.
    model.control.contactStepLimit = 0.5;
    const auto advice = contactStepAdvice(model, results);
    ASSERT_TRUE(advice);
    EXPECT_EQ(advice->subject, "timeStep.contactLimit 1 instead of 0.5");
    EXPECT_TRUE(says(advice->reason, "made 1.8 times the steps that its elements need"));
    EXPECT_TRUE(says(advice->reason, "limited by contact pair touch: node 3"));
    EXPECT_TRUE(says(advice->saving, "up to 44 % of the steps"));
    EXPECT_TRUE(advice->measureOnly);

    model.control.contactStepLimit = 1;
    model.contactPairs[0].normalScale = 2;
    const auto softer = contactStepAdvice(model, results);
    ASSERT_TRUE(softer);
    EXPECT_EQ(softer->edits.changes.at(0).path, "pairs.touch.normalScale");
    EXPECT_EQ(softer->edits.changes.at(0).value, "0.6");
}

TEST_F(CostAdviceTest, StepsThatElementsOrTheUserSetAreNoMatterOfContact)
{
    results.steps->count = 600; // 1.08 times those of the elements
    EXPECT_FALSE(contactStepAdvice(model, results));
    results.steps->count = 1000;
    model.control.fixedTimeStep = 1e-7;
    EXPECT_FALSE(contactStepAdvice(model, results));
    model.control.fixedTimeStep = 0;
    results.steps.reset();
    EXPECT_FALSE(contactStepAdvice(model, results));
}

TEST_F(CostAdviceTest, AFewSmallElementsThatSetTheStepAreNamed)
{
    EXPECT_FALSE(elementsAdvice(model));
    Model sliver;
    addBox(sliver.mesh, "even", {10, 5, 1}, {0, 0, 0}, {10, 5, 1});
    addBox(sliver.mesh, "thin", {1, 1, 1}, {0, 0, 2}, {1, 1, 0.1});
    sliver.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "even"),
                    aluminium(PartKind::elastic, HourglassForm::physical, "thin")};
    const auto advice = elementsAdvice(sliver);
    ASSERT_TRUE(advice);
    EXPECT_TRUE(says(advice->subject, "1 of 51 elements (part thin")) << advice->subject;
    EXPECT_TRUE(says(advice->reason, "10 times as fast"));
    EXPECT_TRUE(says(advice->saving, "up to 90 % of the steps"));
    EXPECT_FALSE(advice->isMade());
    sliver.parts[1].density *= 100; // waves in it are as slow
    EXPECT_FALSE(elementsAdvice(sliver));
    sliver.parts[1].density /= 100;
    sliver.parts[1].targetStep = 1e-7;
    EXPECT_FALSE(elementsAdvice(sliver)) << "its mass is scaled";
    sliver.parts[1].targetStep = 0;
    sliver.parts[1].kind = PartKind::rigidFree;
    EXPECT_FALSE(elementsAdvice(sliver));
}

TEST_F(CostAdviceTest, ThreadsShouldFitTheMachine)
{
    EXPECT_FALSE(threadsAdvice(model, 2)) << "threads 0 follows the idle cores";
    model.control.threads = 8;
    EXPECT_FALSE(threadsAdvice(model, 8));
    ASSERT_TRUE(threadsAdvice(model, 2));
    EXPECT_EQ(threadsAdvice(model, 2)->subject, "threads 0 instead of 8");
    model.control = {};
    model.control.backend = "serial";
    EXPECT_FALSE(threadsAdvice(model, 2)) << "few elements";
    model.mesh.hexahedra.resize(1000);
    EXPECT_FALSE(threadsAdvice(model, 1));
    ASSERT_TRUE(threadsAdvice(model, 2));
    EXPECT_EQ(threadsAdvice(model, 2)->subject, "backend openmp, threads 0");
    EXPECT_EQ(threadsAdvice(model, 2)->edits.changes.size(), 2u);
}

} // namespace fpm::test
