#include "model/InitialDepth.h"

#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// A block `depth` deep in a plate of thickness 1, elements of 1 / layers.
Model blockInPlate(double depth, Index layers, double slant)
{
    Model model;
    addBox(model.mesh, "plate", {7, 7, layers}, {-3, -3, -1}, {10, 10, 1});
    addBox(model.mesh, "block", {3, 4, 3}, {0, 0, -depth}, {4, 4, 4});
    for (Point& p : model.mesh.points) p[2] += slant * p[0];
    renumber(model.mesh);
    model.parts = {aluminium(PartKind::elastic, HourglassForm::physical, "plate"),
                   aluminium(PartKind::elastic, HourglassForm::physical, "block")};
    addContact(model, "touch", skin(model.mesh, model.mesh.findPart("block")),
               skin(model.mesh, model.mesh.findPart("plate")));
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

/// What set-up says of the start is what contact does at the start.
TEST(InitialDepth, IsHeldInTheRunWhereSetUpSaysSo)
{
    for (const double slant : {0.0, 0.2})
        for (const Index layers : {1, 3})
            for (const double depth : {0.05, 0.16, 0.18, 0.3, 0.45, 0.48, 0.52, 0.7, 0.9}) {
                const Model model = blockInPlate(depth, layers, slant);
                const InitialDepths depths = initialDepths(model.mesh, model.mesh.contact.front());
                const auto solver = startedSolver(model);
                EXPECT_EQ(std::size_t(solver->contact().initialOverlap(0).count),
                          depths.held.size())
                    << depth << " in " << layers << " layers, slant " << slant;
                EXPECT_EQ(depths.held.size() + depths.tooDeep.size(), 20u);
                EXPECT_EQ(solver->ledger().energies().contact > 0, !depths.held.empty());
            }
}

} // namespace
} // namespace fpm::test
