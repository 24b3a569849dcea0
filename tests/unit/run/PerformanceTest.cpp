#include "run/Performance.h"

#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

TEST(Performance, LimitOfTheStepNamesThePairOrTheElement)
{
    Model model = twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                            aluminium(PartKind::elastic, HourglassForm::stiffness), {0, 0, 0}, 0);
    for (const double scale : {1e-3, 30.0}) {
        model.contactPairs[0].normalScale = scale;
        const auto solver = startedSolver(model);
        solver->advance(1, 3);
        const std::string text = stepLimit(*solver, model);
        if (scale < 1) {
            EXPECT_NE(text.find("of part upper"), std::string::npos) << text;
            continue;
        }
        EXPECT_NE(text.find("contact pair touch: node "), std::string::npos) << text;
        // By hand: 2 k / m of the worst contact node is what the clock has.
        EXPECT_EQ(solver->contact().bound().frequency, solver->clock().contactFrequency);
    }
}

} // namespace
} // namespace fpm::test
