#pragma once

#include "kernels/material/MaterialConstants.h"
#include "kernels/material/TrialStress.h"

#include <array>
#include <limits>

namespace fpm {

/// A number of a law in a dictionary, with its word, unit and range; the bounds belong to the range
/// unless they are open.
struct Parameter {
    const char* word;
    const char* meaning;
    const char* unit; ///< "stress", "angle in degrees", "-"
    double lower = 0, upper = std::numeric_limits<double>::infinity();
    bool lowerOpen = false, upperOpen = false;
    bool required = true;
    double preset = 0; ///< where it is not required
};

/// What is wrong with numbers that are each within their range.
struct ParameterFault {
    int parameter = -1; ///< the one at fault, -1: none
    const char* message = nullptr;
    const char* advice = nullptr;
};

/// What an integration point keeps from step to step beside its stress.
struct KeptState {
    bool plasticStrain;
    bool backstress = false;
    bool temperature = false;
};

/// What an integration point brings to its stress return.
template <class T>
struct FlowPoint {
    T plasticStrain;
    T bending;         ///< equivalent bending stress of the section, 0 for none
    T temperatureRise; ///< since the start
    ScalarOf<T> rate;  ///< 1 / step, 0 when the step is 0
};

/// Outcome of a stress update beyond the stress itself.
template <class T>
struct PlasticStep {
    T strainIncrement; ///< of the equivalent plastic strain
    T work;            ///< plastic work of the stress per volume
    T reduction;       ///< share of the trial deviator the return takes away, 0 when elastic
};

/// How the bending of an element (PhysicalHourglass) yields once its law has returned the stress.
enum class SectionRule {
    limitSurface, ///< along the normal of the limit surface of a solid section: Mises plasticity
    radial        ///< by the share that the deviator loses: the yield stress follows the pressure
};

/// What every law is; doc/extending.md shows one from begin to end. A law derives from it and adds:
///
///     word, name             of `model` in a dictionary, and in reports
///     parameters             those of its own dictionary <word> { ... }, an array
///     fault(values)          what is wrong with them together
///     constants(...)         what the kernel needs of them, into MaterialConstants::law
///     plastic                whether stress may return to a yield surface at all
///     general                whether the options of a part are asked for at run time: rotation,
///                            deletion, heating; see GeneralConstants
///     heats                  whether plastic work may heat it
///     everyElement           whether it has kernels in every element (hasKernel)
///     section                see SectionRule
///     kept(m)                the state of its points
///     update(m, point, s, a) takes the elastic trial stress s, and the backstress a, back
///     strength(m, point, s)  Mises stress at which the stress s would yield in slow flow, 0: any;
///                            not asked of a law that is not plastic
struct MaterialLaw {
    static constexpr std::array<Parameter, 0> parameters{};
    static constexpr bool plastic = true, general = true, heats = false, everyElement = false;
    static constexpr SectionRule section = SectionRule::limitSurface;

    static constexpr ParameterFault fault(const double*) { return {}; }
    /// `values`: the parameters in their order. The elastic constants of `m` are there already.
    static void constants(const double*, MaterialConstants<double>&) {}
    template <class Work>
    FPM_KERNEL static constexpr KeptState kept(const MaterialConstants<Work>& m)
    {
        return {true, false, m.general.heatPerWork > Work(0)};
    }
};

} // namespace fpm
