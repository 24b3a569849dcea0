#include "run/KernelReport.h"

#include "unit/solver/scenes.h"

#include <gtest/gtest.h>

namespace fpm::test {
namespace {

/// Plastic on elastic, rough.
Model roughPair()
{
    return twoBlocks(aluminium(PartKind::elastoplastic, HourglassForm::physical, "upper"),
                     aluminium(PartKind::elastic, HourglassForm::viscous, "lower"), {0, 0, 0}, 0.3);
}

TEST(KernelReport, TellsWhatEveryPartAndPairUses)
{
    Model model = roughPair();
    // J2 keeps 6 stresses and 12 hourglass forces of 8 bytes and a plastic strain; elastic and
    // viscous 6 stresses.
    EXPECT_EQ(
        kernelLines(*makeSolver(model), model),
        (std::vector<std::string>{
            "elements of lower: one point, elastic, hourglass viscous; 48 bytes of state each",
            "elements of upper: one point, J2 plasticity, hourglass physical; 152 bytes of "
            "state each",
            "contact touch: search faces, friction; 30 contactors on 56 faces"}));
    model.parts[0].hourglassStorage = model.parts[1].hourglassStorage = HourglassStorage::float_;
    const std::vector<std::string> floats = kernelLines(*makeSolver(model), model);
    EXPECT_NE(floats[0].find("48 bytes"), std::string::npos); // viscous keeps none
    EXPECT_NE(floats[1].find("104 bytes of state each; hourglass forces as float: upper"),
              std::string::npos)
        << floats[1];
    model.control.precision = Precision::mixed; // half of all but the plastic strain
    EXPECT_NE(kernelLines(*makeSolver(model), model)[1].find("80 bytes"), std::string::npos);
}

TEST(KernelReport, NamesWhatIsChosenAndNothingElse)
{
    Model model = roughPair();
    model.parts[0].kind = PartKind::rigidPrescribed;
    model.parts[1].hexahedron = HexahedronForm::selective;
    ContactPair& pair = model.contactPairs[0];
    pair.friction = 0;
    pair.normalDamping = 0.1;
    pair.search = ContactSearch::closestParticle;
    pair.projection = ContactProjection::cold;
    const std::vector<std::string> lines = kernelLines(*makeSolver(model), model);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_NE(lines[0].find("upper: eight points"), std::string::npos) << lines[0];
    EXPECT_EQ(lines[1], "no element work: lower, rigid");
    EXPECT_NE(lines[2].find("search closestParticle, cold projection, damping;"), std::string::npos)
        << lines[2];
}

} // namespace
} // namespace fpm::test
