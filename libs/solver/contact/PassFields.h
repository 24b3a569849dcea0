#pragma once

#include "fields/Field.h"
#include "fields/NumberField.h"
#include "kernels/contact/broad/CellLists.h"
#include "solver/contact/ContactSetUp.h"

namespace fpm {

/// One pass of a contact pair: surfaces, and what its contactors keep. A value that contactors are
/// to keep from step to step is one line here.
struct PassFields : FieldSet {
    PassFields(const ContactPassSetup& setUp, const Memory& memory, const NumberTypes& numbers);

    Field<Index> contactor{*this, {"contactor", Location::contactor, Role::derived}};
    Field<Index> ownFaceStart{*this, {"ownFaceStart", Location::table, Role::derived}};
    Field<Index> ownFaces{*this, {"ownFaces", Location::table, Role::derived}};
    Field<Index> ownFaceNode{*this, {"ownFaceNode", Location::table, Role::derived}};
    Field<Index> faceNode{*this, {"faceNode", Location::face, Role::derived}};
    Field<Index> nextAround{*this, {"nextAround", Location::face, Role::derived}};
    Field<Index> neighbour{*this, {"neighbour", Location::face, Role::derived}};
    Field<Index> targetCorner{*this, {"targetCorner", Location::table, Role::derived}};
    Field<Index> excludedStart{*this, {"excludedStart", Location::table, Role::derived}};
    Field<Index> excluded{*this, {"excluded", Location::table, Role::derived}};
    Field<Index> faceComponent{*this, {"faceComponent", Location::face, Role::derived}};
    Field<Index> contactorComponent{*this, {"contactorComponent", Location::table, Role::derived}};
    Field<std::uint8_t> mayMeet{*this, {"mayMeet", Location::table, Role::derived}};
    Field<std::uint8_t> mirrors{*this, {"mirrors", Location::contactor, Role::derived}};
    NumberField mirrorNormal{*this, {"mirrorNormal", Location::table, Role::derived}, Family::work};
    NumberField faceStiffness{
        *this, {"faceStiffness", Location::face, Role::derived}, Family::work};
    NumberField faceMass{*this, {"faceMass", Location::face, Role::derived}, Family::work};
    Field<float> faceThickness{*this, {"faceThickness", Location::face, Role::derived}};
    NumberField contactorStiffness{
        *this, {"contactorStiffness", Location::contactor, Role::derived}, Family::work};
    NumberField contactorMass{
        *this, {"contactorMass", Location::contactor, Role::derived}, Family::work};
    /// Of segments of edges, see EdgePassView.
    Field<Index> edgeNode{*this, {"edgeNode", Location::face, Role::derived}};
    Field<Index> edgeNext{*this, {"edgeNext", Location::face, Role::derived}};
    Field<Index> firstEnds{*this, {"firstEnds", Location::face, Role::derived}};
    Field<Index> secondEnds{*this, {"secondEnds", Location::face, Role::derived}};
    /// Blocks where threads of the CPU need atomic additions; null: none or all.
    Field<std::uint8_t> shared{*this, {"shared", Location::block, Role::derived}};

    Field<std::int16_t> ownNormal{*this, {"ownNormal", Location::contactor, Role::state}};
    /// Renewal changes the numbers of faces.
    Field<Index> face{*this, {"face", Location::contactor, Role::state}};
    Field<Index> frictionFace{
        *this, {"frictionFace", Location::contactor, Role::state, Renewal::keptInContact}};
    Field<std::uint8_t> edgeState{
        *this, {"edgeState", Location::contactor, Role::state, Renewal::keptInContact}};
    Field<std::uint8_t> edgePhase{*this, {"edgePhase", Location::contactor, Role::scratch}};
    Field<Index> passedOn{*this, {"passedOn", Location::contactor, Role::scratch}};
    Field<std::uint8_t> around{*this, {"around", Location::contactor, Role::state}};
    NumberField xi{
        *this, {"xi", Location::contactor, Role::state, Renewal::keptInContact}, Family::work};
    NumberField eta{
        *this, {"eta", Location::contactor, Role::state, Renewal::keptInContact}, Family::work};
    NumberField tangentialForce{
        *this,
        {"tangentialForce", Location::contactor, Role::state, Renewal::keptInContact},
        Family::work};
    /// Of SlipDamping.
    NumberField slipRate{*this,
                         {"slipRate", Location::contactor, Role::state, Renewal::keptInContact},
                         Family::work};
    NumberField heldStiffness{
        *this,
        {"heldStiffness", Location::contactor, Role::state, Renewal::keptInContact},
        Family::work};
    Field<float> overlap{*this,
                         {"overlap", Location::contactor, Role::state, Renewal::keptInContact}};
    /// Forces on blocks of contactors, see BlockForce, and on each contactor where it may leave.
    Field<std::int64_t> force{*this, {"force", Location::block, Role::state}};
    Field<std::int64_t> contactorForce{*this, {"contactorForce", Location::contactor, Role::state}};
    /// Of an analytic surface on each contactor.
    Field<double> surfaceForce{
        *this, {"surfaceForce", Location::contactor, Role::state, Renewal::keptInContact}};
    Field<double> springEnergy{
        *this, {"springEnergy", Location::contactor, Role::state, Renewal::keptInContact}};
    /// Of the normal spring, see TouchMemory.
    NumberField touchGap{*this,
                         {"touchGap", Location::contactor, Role::state, Renewal::keptInContact},
                         Family::work};
    NumberField touchExtra{*this,
                           {"touchExtra", Location::contactor, Role::state, Renewal::keptInContact},
                           Family::work};
    Field<double> touchSurplus{*this,
                               {"touchSurplus", Location::contactor, Role::state, Renewal::kept}};
    Field<double> dampingForce{
        *this, {"dampingForce", Location::contactor, Role::state, Renewal::keptInContact}};
    Field<double> dissipated{*this,
                             {"dissipated", Location::contactor, Role::state, Renewal::kept}};
    Field<double> damped{*this, {"damped", Location::contactor, Role::state, Renewal::kept}};
    Field<double> surfaceWork{*this,
                              {"surfaceWork", Location::contactor, Role::state, Renewal::kept}};
    /// Of a surface that is met exactly, see SurfaceReading.
    Field<double> reading{*this, {"reading", Location::contactor, Role::scratch}};
    /// Two planes, see ContactPassView.
    Field<double> injected{*this, {"injected", Location::contactor, Role::state, Renewal::kept}};
    Field<std::int64_t> counts{*this, {"counts", Location::global, Role::state}};

    /// Cells of the last search: the tracker reads them where what is near is intricate.
    Field<Index> head{*this, {"head", Location::table, Role::state}};
    Field<CellEntry> entries{*this, {"entries", Location::table, Role::state}};
    Field<double> sums{*this, {"sums", Location::block, Role::scratch}};
    /// Results of a reading; see StatusSums and the gaps.
    Field<double> status{*this, {"status", Location::block, Role::scratch}};
    Field<double> gap{*this, {"gap", Location::contactor, Role::scratch}};

    /// Throws Error(checkpoint) where a restored number of a face or cell entry is none there is:
    /// kernels follow them unseen.
    void requireNumbers() const;

    std::uint32_t cellMask = 0; ///< of the hash into `head`

private:
    void allocateState(const ContactPassSetup& setUp);
    void allocateCells(const ContactPassSetup& setUp);
};

bool hasDamping(const ContactPassSetup& pass);
bool hasFriction(const ContactPassSetup& pass);
bool hasSlipDamping(const ContactPassSetup& pass);
/// The stored tangential force is kept in the frame of a face.
bool hasConvectedFriction(const ContactPassSetup& pass);

} // namespace fpm
