#pragma once

#include "fields/Field.h"
#include "fields/NumberField.h"
#include "solver/elements/ElementSetUp.h"

namespace fpm {

/// What the elements keep, patch by patch; see ElementForces.
struct ElementFields : FieldSet {
    /// `interiorEnd`: as NodeSetUp.
    ElementFields(const ElementSetUp& setUp,
                  std::size_t interiorEnd,
                  const Memory& memory,
                  const NumberTypes& numbers);

    Field<PatchHeader> patches{*this, {"patches", Location::patch, Role::constant}};
    /// MaterialConstants of the working type, as bytes.
    Field<std::byte> materials{*this, {"materials", Location::table, Role::constant}};
    /// Patches of all kernel groups in a row, those of group g from groupStart[g] on.
    Field<Index> groupPatches{*this, {"groupPatches", Location::table, Role::constant}};
    std::vector<std::size_t> groupStart;
    Field<std::uint16_t> corners{*this, {"corners", Location::table, Role::constant}};
    Field<std::uint16_t> cornerStarts{*this, {"cornerStarts", Location::table, Role::constant}};
    Field<std::uint16_t> slotCorners{*this, {"slotCorners", Location::table, Role::constant}};
    Field<Index> boundaryNodes{*this, {"boundaryNodes", Location::table, Role::constant}};
    NumberField mass{*this, {"mass", Location::element, Role::constant}, Family::work};
    NumberField massRatio{*this, {"massRatio", Location::element, Role::constant}, Family::work};

    /// Stress, backstress and hourglass values, in tiles; see StateLayout.
    NumberField state{*this, {"state", Location::element, Role::state}, Family::work};
    /// Plastic strain and rise of temperature, in tiles.
    NumberField plasticStrain{
        *this, {"plasticStrain", Location::element, Role::state}, Family::sum};
    /// Internal forces of this time: of nodes of one patch, and partial sums of the others.
    NumberField interiorForce{*this, {"interiorForce", Location::node, Role::state}, Family::work};
    NumberField partialForce{*this, {"partialForce", Location::table, Role::state}, Family::work};
    Field<double> patchEnergy{*this, {"patchEnergy", Location::patch, Role::state}};
    /// Bound of the next step from each patch.
    Field<double> patchStep{*this, {"patchStep", Location::patch, Role::state}};
};

} // namespace fpm
