#include "mesh/Quality.h"
#include "solver/ledger/Ledger.h"

namespace fpm {

/// All elements strained by ten million times the rounding of a position, in single precision by a
/// hundred times. A smooth load begins with less: then displacement increments are rounded to few
/// digits, and a zero gap opens and closes by rounding.
double roundingEnergy(const Model& model)
{
    const double strain = model.control.precision == Precision::single ? 1e-5 : 1e-9;
    double energy = 0;
    for (Index element = 0; element < Index(model.mesh.hexahedra.size()); ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        if (!isRigid(part.kind))
            energy += 0.5 * part.youngsModulus * strain * strain * volume(model.mesh, element);
    }
    return energy;
}

} // namespace fpm
