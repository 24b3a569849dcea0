#pragma once

#include "kernels/TypeList.h"
#include "kernels/material/DruckerPrager.h"
#include "kernels/material/GeneralPlasticity.h"
#include "kernels/material/ZerilliArmstrong.h"

#include <span>

namespace fpm {

/// Every material that `model` may name, in the order of their numbers. A further one is its header
/// and its name here; dictionary, kernels, layout of the state and reports follow from it.
using Materials = TypeList<Elastic, J2Plasticity, DruckerPrager, ZerilliArmstrong>;

/// The law that serves parts of a material which ask for options at run time.
template <class Material>
using WithOptions = std::conditional_t<Material::general, Material, GeneralPlasticity>;

/// A law as programs without kernels see it.
struct MaterialEntry {
    const char *word, *name;
    std::span<const Parameter> parameters;
    bool plastic, heats;
    ParameterFault (*fault)(const double* values);
    void (*constants)(const double* values, MaterialConstants<double>& m);
};

template <class Material>
inline constexpr MaterialEntry materialEntry{
    Material::word,  Material::name,   Material::parameters, Material::plastic,
    Material::heats, &Material::fault, &Material::constants};

/// Of Materials, in their order.
inline constexpr auto materialEntries = []<class... M>(TypeList<M...>) {
    return std::array<MaterialEntry, sizeof...(M)>{materialEntry<M>...};
}(Materials{});

} // namespace fpm
