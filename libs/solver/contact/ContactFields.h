#pragma once

#include "solver/contact/ListFields.h"
#include "solver/contact/PassFields.h"

#include <memory>

namespace fpm {

/// The nodes that contact acts on, all passes and their lists.
struct ContactFields : FieldSet {
    ContactFields(const ContactSetUp& setUp, const Memory& memory, const NumberTypes& numbers);
    /// Contact nodes of renewed surfaces, without values of the old ones.
    void renewNodes(const ContactSetUp& setUp);
    /// Lists of all passes that search faces; new ones.
    void renewLists(const NearBlocks& near);
    /// What kernels know of the passes that are kinematic; after any pass is made anew.
    void bindSurfaces(const ContactSetUp& setUp);
    /// Blocks of contact nodes.
    std::size_t blocks() const { return bound.size(); }

    Field<Index> nodes{*this, {"nodes", Location::contactNode, Role::derived}};
    Field<Index> numberOf{*this, {"numberOf", Location::node, Role::derived}};
    /// Force and stiffness of this time in fixed point, [contact node][4]; see ContactSums.
    Field<std::int64_t> sum{*this, {"sum", Location::contactNode, Role::state}};
    /// Square of the largest frequency of the contact springs in a block, for the next step.
    Field<double> bound{*this, {"bound", Location::block, Role::state}};
    Field<double> referenceDisplacement{*this,
                                        {"referenceDisplacement", Location::block, Role::scratch}};
    Field<double> referenceOrigin{*this, {"referenceOrigin", Location::block, Role::state}};
    Field<float> referenceOffset{*this, {"referenceOffset", Location::contactNode, Role::state}};
    /// See KinematicContact.
    Field<Index> surfaceStart{*this, {"surfaceStart", Location::table, Role::derived}};
    Field<SurfaceUse> surfaceUses{*this, {"surfaceUses", Location::table, Role::derived}};
    Field<KinematicPass> kinematicPasses{*this,
                                         {"kinematicPasses", Location::table, Role::derived}};
    Field<PassListState> lists{*this, {"lists", Location::table, Role::state}};

    std::vector<std::unique_ptr<PassFields>> passes;
    std::vector<std::unique_ptr<ListFields>> passLists; ///< of the passes whose lists last
};

} // namespace fpm
