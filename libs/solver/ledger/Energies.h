#pragma once

#include <vector>

namespace fpm {

/// What the elements of one part hold and have dissipated; see Energies.
struct PartEnergies {
    double internal = 0, plastic = 0, hourglass = 0;
};

/// The ledger at one time: work and energy in the case's units.
struct Energies {
    double time = 0;
    double kinetic = 0;
    double internal = 0;  ///< elastic and plastic work of the elements; that of their bending too,
                          ///< where the form of hourglass control is `physical`
    double plastic = 0;   ///< of internal: plastic work
    double hourglass = 0; ///< of spurious modes
    double bulkViscosity = 0;
    std::vector<PartEnergies> parts; ///< as Model::parts
    double contact = 0; ///< in the penalty springs, recoverable but for those of deleted faces
    double friction = 0, contactDamping = 0, damping = 0;
    double external = 0; ///< done by loads, drives and moving surfaces
    double total = 0;    ///< everything held or dissipated
    /// Kinetic over what elements hold and have dissipated: how much inertia there is in a slow
    /// run.
    double kineticShare() const
    {
        return internal + hourglass > 0 ? kinetic / (internal + hourglass) : 0;
    }
    double error = 0;   ///< total - external - start
    double scale = 0;   ///< largest so far of kinetic, internal, external, lost to friction and
                        ///< damping, start, and of what rounding explains: see roundingEnergy
    double balance = 0; ///< error / scale
};

/// Works done on the nodes up to a time, trapezoidal: what the exact discrete identity sums.
struct NodalWorks {
    double internal = 0, contact = 0, external = 0, drives = 0, damping = 0;
};

} // namespace fpm
