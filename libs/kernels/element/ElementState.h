#pragma once

#include "parallel/Vec3.h"

namespace fpm {

/// State of an element before the step, and after updateHexahedron.
template <class T>
struct ElementState {
    Sym3<T> stress;            ///< Cauchy, global axes
    T equivalentPlasticStrain; ///< negative: the element is deleted (Deletion.h)
    Vec3<T> hourglass[4];      ///< forces Q_j, or strains c_j of the physical form
    Sym3<T> backstress;        ///< deviator; only for parts with kinematic hardening
    T temperatureRise;         ///< since the start; only for parts with heating
};

/// Energy increments of one element in one step, and its stable time step.
template <class T>
struct ElementStep {
    T internal, hourglass, bulkViscosity; ///< work done in this step
    T plastic;                            ///< plastic dissipation, also of bending: part of
                                          ///< internal
    T plasticStrainIncrement;
    T stableTimeStep;       ///< Flanagan-Belytschko with bulk viscosity; <= 0 or NaN: inverted
    T temperatureIncrement; ///< only GeneralPlasticity
    T deletes;              ///< 1: this step deletes the element, 0: not; only GeneralPlasticity
};

/// Work in a step of the forces at its start.
template <class T>
struct ElementWork {
    T internal, hourglass;
};

} // namespace fpm
