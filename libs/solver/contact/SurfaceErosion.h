#pragma once

#include "solver/SetUp.h"

namespace fpm {

/// The host's part of erosion: what becomes of the contact surfaces when elements are deleted.
class SurfaceErosion
{
public:
    explicit SurfaceErosion(const Model& model);

    /// Replaces the contact part of `data` by that of the surfaces without the elements in
    /// `deleted`. False, and `data` as it was, when no surface changes.
    bool renewContact(SolverSetUp& data, const std::vector<bool>& deleted);

    /// The surface `original` after deletions: its sides of deleted elements leave, and what they
    /// covered joins: sides of living elements of the same part that face a deleted element which
    /// had, or in its time would have had, a side in the surface. Ascending.
    std::vector<ElementSide> renewedSides(const std::vector<ElementSide>& original,
                                          const std::vector<bool>& deleted) const;

private:
    Index neighbour(const ElementSide& side) const;

    Model model_; ///< mesh, parts, conditions and pairs, with the present surfaces
    std::vector<ContactSurfaces> original_; ///< as model_.contactPairs
    std::vector<Index> neighbours_;         ///< [element][side], -1: outside or another part
};

/// What a renewed pair takes over from the old one: of each new contactor its old number, of each
/// old face its new one; -1: none.
struct PassRenewal {
    std::vector<Index> contactor, face;
};
PassRenewal compared(const ContactPassSetup& before, const ContactPassSetup& after);

} // namespace fpm
