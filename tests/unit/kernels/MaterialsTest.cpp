#include "kernels/element/ElementKernels.h"
#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

using namespace fpm;

// What every law of the list must keep to, whatever it is.

TEST(Materials, EveryLawAndEveryParameterHasItsOwnWord)
{
    std::set<std::string> words;
    for (const MaterialEntry& material : materialEntries) {
        EXPECT_TRUE(words.insert(material.word).second) << material.word;
        std::set<std::string> parameters;
        for (const Parameter& p : material.parameters) {
            EXPECT_TRUE(parameters.insert(p.word).second) << material.word << ' ' << p.word;
            EXPECT_LT(p.lower, p.upper) << material.word << ' ' << p.word;
            EXPECT_GT(std::strlen(p.meaning), 0u);
            EXPECT_GT(std::strlen(p.unit), 0u);
            EXPECT_TRUE(p.required || (p.preset >= p.lower && p.preset <= p.upper)) << p.word;
        }
    }
}

TEST(Materials, EveryLawHasAKernelInTheUsualElementWithAndWithoutOptions)
{
    const int usual = Elements::indexOf<ReducedHexahedron<PhysicalHourglass>>();
    for (int material = 0; material < Materials::size; ++material)
        for (const bool options : {false, true})
            EXPECT_TRUE(isKernel(kernelOf(material, usual, options))) << material;
    EXPECT_FALSE(isKernel(kernelOf(Materials::size, usual, false)));
}

TEST(Materials, AKernelIsVisitedWithTheTypesOfItsNumbers)
{
    int visits = 0;
    const ElementKernel kernel{Laws::indexOf<J2Plasticity>(),
                               Elements::indexOf<ReducedHexahedron<ViscousHourglass>>()};
    visitKernel(kernel, [&]<class Law, class Element>() {
        ++visits;
        EXPECT_TRUE((std::is_same_v<Law, J2Plasticity>));
        EXPECT_TRUE((std::is_same_v<Element, ReducedHexahedron<ViscousHourglass>>));
    });
    EXPECT_EQ(visits, 1);
    // Eight points ask for options at run time, which the plain laws have not.
    EXPECT_FALSE(isKernel({Laws::indexOf<Elastic>(), Elements::indexOf<SelectiveHexahedron>()}));
}

// Constants are converted member by member: one that was forgotten would be 0.
TEST(Materials, EveryConstantIsConverted)
{
    MaterialConstants<double> m;
    std::memset(static_cast<void*>(&m), 0, sizeof m);
    double* numbers[] = {&m.lambda,
                         &m.twoMu,
                         &m.threeMu,
                         &m.pressureWaveModulus,
                         &m.young,
                         &m.poisson,
                         &m.linearViscosity,
                         &m.quadraticViscosity,
                         &m.hourglass,
                         &m.coupledHourglass,
                         &m.general.kinematicModulus,
                         &m.general.powerModulus,
                         &m.general.powerExponent,
                         &m.general.referenceRate,
                         &m.general.rateCoefficient,
                         &m.general.heatPerWork,
                         &m.general.temperature,
                         &m.general.softeningExponent,
                         &m.general.roomTemperature,
                         &m.general.inverseMeltingRange,
                         &m.general.erosionStrain};
    double next = 1;
    for (double* number : numbers) *number = next++;
    m.rows = maxHardeningRows;
    for (int row = 0; row < m.rows; ++row) {
        m.strain[row] = next++;
        m.stress[row] = next++;
        m.slope[row] = next++;
    }
    for (double& constant : m.law) constant = next++;
    m.floatHourglass = m.general.erodes = m.general.erodesInverted = true;
    m.general.rotation = RotationRule::polar;
    m.general.rateLaw = RateLaw::logarithmic;
    const auto back = m.converted<float>().converted<double>();
    EXPECT_EQ(std::memcmp(&m.lambda, &back.lambda, 10 * sizeof(double)), 0);
    EXPECT_EQ(back.rows, m.rows);
    EXPECT_TRUE(back.floatHourglass && back.general.erodes && back.general.erodesInverted);
    EXPECT_EQ(back.general.rotation, m.general.rotation);
    EXPECT_EQ(back.general.rateLaw, m.general.rateLaw);
    for (int row = 0; row < m.rows; ++row) {
        EXPECT_EQ(back.strain[row], m.strain[row]);
        EXPECT_EQ(back.stress[row], m.stress[row]);
        EXPECT_EQ(back.slope[row], m.slope[row]);
    }
    for (int i = 0; i < maxLawConstants; ++i) EXPECT_EQ(back.law[i], m.law[i]);
    const GeneralConstants<double>&a = m.general, &b = back.general;
    EXPECT_EQ(b.kinematicModulus, a.kinematicModulus);
    EXPECT_EQ(b.powerModulus, a.powerModulus);
    EXPECT_EQ(b.powerExponent, a.powerExponent);
    EXPECT_EQ(b.referenceRate, a.referenceRate);
    EXPECT_EQ(b.rateCoefficient, a.rateCoefficient);
    EXPECT_EQ(b.heatPerWork, a.heatPerWork);
    EXPECT_EQ(b.temperature, a.temperature);
    EXPECT_EQ(b.softeningExponent, a.softeningExponent);
    EXPECT_EQ(b.roomTemperature, a.roomTemperature);
    EXPECT_EQ(b.inverseMeltingRange, a.inverseMeltingRange);
    EXPECT_EQ(b.erosionStrain, a.erosionStrain);
}
