#include "stability/Bounds.h"

#include "mesh/Patches.h"
#include "mesh/Surface.h"
#include "mesh/addBox.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fpm {
namespace {

/// Bars of unit cubes along z that cannot move sideways: rows of one-dimensional elements.
Model bars(int count)
{
    Model model;
    Part part;
    part.density = 2.7e-9;
    part.youngsModulus = 70000;
    part.poissonsRatio = 0.3;
    for (int bar = 0; bar < count; ++bar) {
        part.name = bar == 0 ? "lower" : "upper";
        addBox(model.mesh, part.name, {1, 1, 8}, {0, 0, bar * 8.0}, {1, 1, 8});
        model.parts.push_back(part);
    }
    renumber(model.mesh);
    BoundaryCondition guide;
    guide.name = "guide";
    guide.constrains = {true, true, false};
    for (Index node = 0; node < Index(model.mesh.points.size()); ++node)
        guide.nodes.push_back(node);
    model.boundaryConditions.push_back(guide);
    model.control.backend = "serial";
    model.control.endTime = 1;
    return model;
}

const double modulus = 70000 * 0.7 / (1.3 * 0.4), waveSpeed = std::sqrt(modulus / 2.7e-9);

TEST(Bounds, LargestFrequencyOfABarIsThatOfTheChain)
{
    // Free ends with half masses: the alternating mode, omega = 2 c / h exactly.
    const Model model = bars(1);
    const Bounds bounds = boundsOf(model);
    EXPECT_NEAR(largestFrequency(model, bounds.elementStep), 2 * waveSpeed, 0.01 * 2 * waveSpeed);
    EXPECT_EQ(bounds.quality, 0);
    EXPECT_EQ(bounds.withContact, 1);
}

TEST(Bounds, AStiffSpringBetweenBarsSetsTheLargestFrequency)
{
    Model model = bars(2);
    ContactPair pair;
    pair.name = "ends";
    std::vector<ElementSide> sides[2];
    for (Index part = 0; part < 2; ++part)
        for (const ElementSide& side : skin(model.mesh, part))
            if ((part == 0 ? 1 : -1) * normal(model.mesh, side)[2] > 0.9
                && std::abs(centre(model.mesh, side)[2] - 8) < 1e-9)
                sides[part].push_back(side);
    pair.contactorNodes = nodesOf(model.mesh, sides[1]);
    pair.targetSides = sides[0];
    pair.normalScale = 100;
    model.mesh.contact.push_back({pair.name, pair.contactorNodes, sides[1], sides[0]});
    model.contactPairs.push_back(pair);

    // k = s K A^2 / V at each of four corners of mass rho V / 8; the bars' own springs add little.
    const double k = 100 * 70000 / (3 * 0.4), mass = 2.7e-9 / 8, spring = std::sqrt(2 * k / mass);
    const Bounds bounds = boundsOf(model);
    EXPECT_NEAR(largestFrequency(model, bounds.elementStep), spring, 0.02 * spring);
    // Gershgorin: twice k over the mass of either side.
    EXPECT_NEAR(bounds.quality * bounds.elementStep * spring, 0.8, 1e-6);
}

} // namespace
} // namespace fpm
