#include "solver/elements/PatchTables.h"
#include "stability/SceneTools.h"
#include "support/solverModel.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

constexpr Index cells = 48;

/// Layers of one element, each on the next, which is where nearly all nodes touch.
Model layers(int count, Precision precision)
{
    Model model;
    const double gap = 0.1;
    const auto name = [](int layer) { return "layer" + std::to_string(layer); };
    for (int layer = 0; layer < count; ++layer) {
        const double z = layer * (1 + gap);
        addBox(model.mesh, name(layer), {cells, cells, 1}, {0, 0, z}, {cells, cells, z + 1});
        model.parts.push_back(
            aluminium(PartKind::elastoplastic, HourglassForm::physical, name(layer)));
    }
    finishScene(model);
    for (int layer = 0; layer + 1 < count; ++layer)
        addContact(model, "pair" + std::to_string(layer),
                   facing(model.mesh, name(layer + 1), {0, 0, -1}),
                   facing(model.mesh, name(layer), {0, 0, 1}));
    model.control.precision = precision;
    return model;
}

double bytesAnElement(const Model& model)
{
    return double(makeSolver(model)->fields().bytes()) / double(model.mesh.hexahedra.size());
}

TEST(Memory, ALayeredPlateHoldsAtMostSoMuchAnElement)
{
    EXPECT_LT(bytesAnElement(layers(4, Precision::double_)), 600);
    EXPECT_LT(bytesAnElement(layers(4, Precision::mixed)), 480);
}

TEST(Memory, PatchesOfOneShapeShareTheirTables)
{
    const SolverSetUp one = makeSetUp(layers(1, Precision::double_)),
                      four = makeSetUp(layers(4, Precision::double_));
    EXPECT_EQ(four.elements.patches.size(), 4 * one.elements.patches.size());
    EXPECT_EQ(four.elements.corners, one.elements.corners);
    EXPECT_EQ(four.elements.cornerStarts, one.elements.cornerStarts);
    EXPECT_EQ(four.elements.slotCorners, one.elements.slotCorners);
}

} // namespace
} // namespace fpm::test
