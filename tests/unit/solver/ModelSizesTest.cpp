#include "solver/elements/ModelSizes.h"

#include "base/Error.h"
#include "unit/solver/kindScenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

std::string refusal(const std::function<void()>& of)
{
    try {
        of();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::mesh);
        EXPECT_FALSE(error.advice().empty());
        return error.what();
    }
    return "";
}
std::string refusal(const ModelSizes& sizes)
{
    return refusal([&] { requirePlaces(sizes); });
}

constexpr std::size_t quarter = std::size_t(1) << 29; // four places each: one too many

TEST(ModelSizes, WhatCannotBeNumberedIsRefusedByName)
{
    EXPECT_EQ(refusal(ModelSizes{}), "");
    EXPECT_NE(refusal({.paddedElements = std::size_t(1) << 28}).find("268435456 elements"),
              std::string::npos);
    EXPECT_NE(refusal({.parts = 46341}).find("46341 parts"), std::string::npos);
    EXPECT_NE(refusal({.pressureSides = quarter}).find("536870912 sides under pressure"),
              std::string::npos);
    EXPECT_NE(refusal({.uses = mostPlaces + 1}).find("2147483648 places"), std::string::npos);
    EXPECT_NE(refusal({.contactNodes = quarter}).find("536870912 nodes in contact"),
              std::string::npos);
    for (const ModelSizes::Pass& pass : {ModelSizes::Pass{"touch", 715827883, 1, 1},
                                         {"touch", 1, quarter, 1},
                                         {"touch", 1, 1, quarter}})
        EXPECT_NE(refusal({.passes = {pass}}).find("pair 'touch'"), std::string::npos);
    EXPECT_NE(refusal([] { requireExclusionPlaces("skin", mostPlaces + 1); }).find("pair 'skin'"),
              std::string::npos);
}

TEST(ModelSizes, WhatJustFitsIsNot)
{
    EXPECT_EQ(refusal({.paddedElements = (std::size_t(1) << 28) - 1,
                       .parts = 46340,
                       .pressureSides = quarter - 1,
                       .uses = mostPlaces,
                       .contactNodes = quarter - 1,
                       .passes = {{"touch", 715827882, quarter - 1, quarter - 1}}}),
              "");
    EXPECT_EQ(refusal([] { requireExclusionPlaces("skin", mostPlaces); }), "");
}

/// The counts are those of the lists that the solver makes.
TEST(ModelSizes, AreThoseOfTheLists)
{
    for (const bool general : {false, true}) {
        Model model = twoBlocks(metal(), metal(), {0, 0, -1e3}, 0);
        if (general) {
            model.contactPairs.clear();
            model.mesh.contact.clear();
            addGeneral(model);
        } else
            model.contactPairs[0].passes = 2;
        BoundaryCondition pressure =
            condition(BoundaryCondition::Kind::pressure, "p", {}, {true, true, true}, {5, 0, 0});
        pressure.sides = facing(model.mesh, "upper", {0, 0, 1});
        pressure.nodes = nodesOf(model.mesh, pressure.sides);
        model.boundaryConditions.push_back(pressure);
        model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "led",
                                                     nodesOfPart(model.mesh, "lower"),
                                                     {true, true, true}, {1, 2, 3}));
        const ModelSizes sizes = sizesOf(model);
        const SolverSetUp data = makeSetUp(model);
        EXPECT_EQ(sizes.paddedElements, std::size_t(data.elements.padded));
        EXPECT_EQ(4 * sizes.pressureSides, data.nodes.pressureSlots.size());
        EXPECT_EQ(sizes.uses, data.nodes.uses.size());
        EXPECT_EQ(sizes.contactNodes, data.contact.nodes.size());
        ASSERT_EQ(sizes.passes.size(), data.contact.passes.size());
        for (std::size_t pass = 0; pass < data.contact.passes.size(); ++pass) {
            EXPECT_EQ(sizes.passes[pass].contactors, data.contact.passes[pass].contactor.size());
            EXPECT_EQ(4 * sizes.passes[pass].ownFaces, data.contact.passes[pass].ownFaces.size());
            EXPECT_EQ(4 * sizes.passes[pass].faces, data.contact.passes[pass].faceNode.size());
        }
    }
}

} // namespace
} // namespace fpm::test
