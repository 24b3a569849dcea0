#pragma once

#include <array>
#include <vector>

namespace fpm::test {

/// Everything updateHexahedron reads for one element, as plain numbers: shared by translation units
/// of different vector width.
struct BatchCase {
    std::array<double, 24> modes;     ///< modes 0..7 of the corner coordinates, xyz each
    std::array<double, 24> increment; ///< modes of the displacement increment
    double mass;
    std::array<double, 6> stress;
    double plasticStrain;
    std::array<double, 12> hourglass;
    std::array<double, 6> backstress;
    double temperatureRise;
};

/// Everything it writes: force modes, stress, hourglass forces, works, strain increment, step; of a
/// general law also backstress, rise of temperature and deletion.
using BatchOutcome = std::array<double, 24 + 6 + 12 + 6 + 6 + 2>;

inline constexpr double batchRate = 25, batchStrainPoint = 0.5;

/// Random warped, stressed elements, some of which yield; defined in BatchElementTest.cpp.
std::vector<BatchCase> batchCases(int count);

/// Outcomes of the three hourglass forms, form by form, from scalar code of the baseline.
std::vector<BatchOutcome> scalarOutcomes(const std::vector<BatchCase>& cases);
std::vector<BatchOutcome> scalarFloatOutcomes(const std::vector<BatchCase>& cases);

/// The same for every law of GeneralPlasticity, law by law.
std::vector<BatchOutcome> generalScalarOutcomes(const std::vector<BatchCase>& cases);
std::vector<BatchOutcome> generalScalarFloatOutcomes(const std::vector<BatchCase>& cases);

/// Adds a failure for the first number whose bits differ.
void expectEqualBits(const std::vector<BatchOutcome>& a, const std::vector<BatchOutcome>& b);

} // namespace fpm::test
