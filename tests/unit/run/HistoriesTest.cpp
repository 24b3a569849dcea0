#include "run/Histories.h"

#include "support/TemporaryFolder.h"
#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace fpm::test {
namespace {

std::vector<std::vector<double>> tableOf(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        rows.emplace_back();
        for (double x; words >> x;) rows.back().push_back(x);
    }
    return rows;
}

TEST(Histories, ReactionHistoriesHaveTravelAndTheForceOfTheWhole)
{
    Model model = twoBlocks(aluminium(PartKind::elastic, HourglassForm::physical),
                            aluminium(PartKind::elastic, HourglassForm::stiffness), {0, 0, 0}, 0);
    RigidSurface wall;
    wall.name = "wall";
    wall.point = {0, 0, -4};
    wall.motion = RigidSurface::Motion::velocity;
    wall.value = {0, 0, 2e3};
    model.rigidSurfaces.push_back(wall);
    addContact(model, "onWall", facing(model.mesh, "lower", {0, 0, -1}), {}).surface = 0;
    model.boundaryConditions.push_back(
        condition(BoundaryCondition::Kind::displacement, "lid",
                  nodesWhere(model.mesh, [](Point p) { return p[2] > 5.99; }), {false, false, true},
                  {0, 0, -0.01}, {Amplitude::Kind::table, {{0, 0}, {1e-5, 1}}}));
    History ofWall, ofLid;
    ofWall.kind = ofLid.kind = History::Kind::reaction;
    ofWall.name = "wall";
    ofWall.surface = 0;
    ofWall.factor = 4;
    ofLid.name = "lid";
    ofLid.condition = 0;
    ofLid.nodes = model.boundaryConditions[0].nodes;
    model.control.histories = {ofWall, ofLid};
    const auto solver = startedSolver(model);
    solver->advance(5e-6, 100000);
    const TemporaryFolder folder;
    const double force = solver->contact().force(1).force[2];
    EXPECT_GT(force, 0);
    {
        Log log = Log::quiet();
        Histories histories(OutputFolder(folder.path()), model, "", {}, log);
        histories.sample(*solver, Sample(*solver, model));
    }
    const auto wallRow = tableOf(folder.path() / "postProcessing/wall/0/reaction.dat").back();
    const auto lidRow = tableOf(folder.path() / "postProcessing/lid/0/reaction.dat").back();
    ASSERT_EQ(wallRow.size(), 5u);
    EXPECT_NEAR(wallRow[1], 0.01, 1e-12); // 2e3 * 5e-6
    EXPECT_NEAR(wallRow[4], 4 * force, 1e-6 * force);
    EXPECT_NEAR(lidRow[1], 0.005, 1e-12);
}

} // namespace
} // namespace fpm::test
