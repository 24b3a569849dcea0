#pragma once

#include "kernels/TypeList.h"
#include "parallel/Kernel.h"

#include <array>

namespace fpm {

// How the stiffnesses of the two sides that meet make that of a contact spring. A rule is a type
// with
//     word       of `penalty` in a dictionary
//     bothSides  whether the contactor's own stiffness counts; otherwise only at rigid faces
//     byMass     k = s m / dt^2 of the masses instead of s K A^2 / V of the elements
//     stiffness  of the spring where both sides are deformable
// and stands in the list PenaltyRules.

struct TargetPenalty {
    static constexpr const char* word = "target";
    static constexpr bool bothSides = false, byMass = false;
    template <class Work>
    FPM_KERNEL static Work stiffness(Work, Work face)
    {
        return face;
    }
};

struct LesserPenalty {
    static constexpr const char* word = "min";
    static constexpr bool bothSides = true, byMass = false;
    template <class Work>
    FPM_KERNEL static Work stiffness(Work own, Work face)
    {
        return own < face ? own : face;
    }
};

struct SeriesPenalty {
    static constexpr const char* word = "series";
    static constexpr bool bothSides = true, byMass = false;
    template <class Work>
    FPM_KERNEL static Work stiffness(Work own, Work face)
    {
        return own * face / (own + face);
    }
};

struct MassPenalty : LesserPenalty {
    static constexpr const char* word = "mass";
    static constexpr bool byMass = true;
};

/// Every rule, in the order of their numbers.
using PenaltyRules = TypeList<TargetPenalty, LesserPenalty, SeriesPenalty, MassPenalty>;

/// A rule as programs without kernels see it.
struct PenaltyEntry {
    const char* word;
    bool bothSides, byMass;
};

/// Of PenaltyRules, in their order.
inline constexpr auto penaltyEntries = []<class... R>(TypeList<R...>) {
    return std::array<PenaltyEntry, sizeof...(R)>{
        PenaltyEntry{R::word, R::bothSides, R::byMass}...};
}(PenaltyRules{});

/// Stiffness of a spring by rule number `rule` of the list.
template <class Work, class... Rules>
FPM_KERNEL Work springStiffness(TypeList<Rules...>, int rule, Work own, Work face)
{
    Work stiffness = face;
    int number = 0;
    ((stiffness = number++ == rule ? Rules::stiffness(own, face) : stiffness), ...);
    return stiffness;
}

} // namespace fpm
