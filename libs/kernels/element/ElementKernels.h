#pragma once

#include "kernels/element/SelectiveHexahedron.h"
#include "kernels/element/StateLayout.h"
#include "kernels/material/Materials.h"

namespace fpm {

/// Forms of hourglass control that a dictionary may name, in the order of their numbers.
using HourglassForms = TypeList<StiffnessHourglass, ViscousHourglass, PhysicalHourglass>;

/// Every element.
using Elements = TypeList<ReducedHexahedron<StiffnessHourglass>,
                          ReducedHexahedron<ViscousHourglass>,
                          ReducedHexahedron<PhysicalHourglass>,
                          SelectiveHexahedron>;

/// Every law that has kernels: those of Materials, and the one that serves their options.
using Laws = Materials::With<GeneralPlasticity>;

/// Whether there is a kernel of a law in an element. Each costs twelve compilations (precisions and
/// vector widths, GPU): a law that does not ask for all elements has those made for every law.
template <class Law, class Element>
inline constexpr bool hasKernel = (Law::general || Element::points == 1)
                                  && (Law::everyElement || Element::everyLaw);

/// A kernel: numbers in Laws and Elements.
struct ElementKernel {
    int law = 0, element = 0;
    friend bool operator==(const ElementKernel&, const ElementKernel&) = default;
};

/// visit.template operator()<Law, Element>() of a kernel; nothing where there is none. The one
/// place where laws and elements meet.
template <class Visit>
void visitKernel(const ElementKernel& kernel, Visit&& visit)
{
    Laws::visit(kernel.law, [&]<class Law>() {
        Elements::visit(kernel.element, [&]<class Element>() {
            if constexpr (hasKernel<Law, Element>) visit.template operator()<Law, Element>();
        });
    });
}

inline bool isKernel(const ElementKernel& kernel)
{
    bool found = false;
    visitKernel(kernel, [&]<class Law, class Element>() { found = true; });
    return found;
}

/// Kernel for a material of Materials in an element of Elements; `options`: asked for at run time.
inline ElementKernel kernelOf(int material, int element, bool options)
{
    ElementKernel kernel{-1, element};
    Materials::visit(material, [&]<class Material>() {
        kernel.law = options ? Laws::indexOf<WithOptions<Material>>() : Laws::indexOf<Material>();
    });
    return kernel;
}

/// Element of one point with form number `hourglass` of HourglassForms.
inline int reducedElement(int hourglass)
{
    int element = -1;
    HourglassForms::visit(
        hourglass, [&]<class Form>() { element = Elements::indexOf<ReducedHexahedron<Form>>(); });
    return element;
}

} // namespace fpm
