#include "run/EnergyHealth.h"

#include "base/Format.h"
#include "run/HealthLimits.h"
#include "solver/Solver.h"

#include <cmath>

namespace fpm {

EnergyHealth::EnergyHealth(const Model& model) : model_(model), parts_(model.parts.size()) {}

void EnergyHealth::sample(const Energies& e, bool judged)
{
    scale_ = e.scale;
    if (judged) balance_.take(std::abs(e.balance), e.time);
    // At the largest compression: at first contact nodes of the surface give springs all that they
    // have, however stiff these are.
    elastic_.take(e.contact + e.internal - e.plastic, e.time);
    if (elastic_.time == e.time) {
        contact_ = e.contact;
        internal_ = e.internal;
    }
    if (model_.control.kineticShare > 0 && e.time >= model_.control.quasiStaticAfter)
        kineticShare_.take(e.kineticShare(), e.time);
    for (std::size_t part = 0; part < parts_.size() && part < e.parts.size(); ++part) {
        OfPart& of = parts_[part];
        of.internal.take(e.parts[part].internal, e.time);
        of.hourglass.take(std::abs(e.parts[part].hourglass), e.time);
    }
}

void EnergyHealth::keep(Archive& archive)
{
    for (OfPart& part : parts_) {
        part.internal.keep(archive);
        part.hourglass.keep(archive);
    }
    balance_.keep(archive);
    kineticShare_.keep(archive);
    elastic_.keep(archive);
    archive(contact_);
    archive(internal_);
    archive(scale_);
}

bool EnergyHealth::counts(double energy) const
{
    return energy > HealthLimits::counts * scale_;
}

void EnergyHealth::addRows(HealthRows& rows) const
{
    const double limit = model_.control.energyWarning;
    rows.push_back({"energy balance error", balance_.value, limit, "", balance_.time,
                    balance_.value > limit,
                    "a smaller timeStep.safety or contactLimit, or softer contact, tells whether "
                    "the step or the contact makes the error"});
    for (std::size_t part = 0; part < parts_.size(); ++part) addPart(part, rows);
    addContact(rows);
    addInertia(rows);
}

void EnergyHealth::addPart(std::size_t part, HealthRows& rows) const
{
    const Part& of = model_.parts[part];
    if (isRigid(of.kind) || of.hexahedron != HexahedronForm::reduced) return;
    const OfPart& had = parts_[part];
    const double spurious = had.hourglass.value, internal = had.internal.value,
                 value = internal > 0   ? spurious / internal
                         : spurious > 0 ? 1e9
                                        : 0;
    const bool judged = counts(spurious);
    rows.push_back(
        {"hourglass / internal energy", value, judged ? HealthLimits::hourglass : 0,
         "part " + of.name + (judged ? "" : ", of little energy"), had.hourglass.time,
         judged && value > HealthLimits::hourglass,
         of.hourglass == HourglassForm::physical
             ? "its elements deform in spurious modes: hexahedron selective (with rotation "
               "hughesWinget), or more elements across the bending"
             : "its elements deform in modes that this form of hourglass control bears "
               "artificially: form physical, hexahedron selective (with rotation "
               "hughesWinget), or more elements across the bending"});
}

void EnergyHealth::addContact(HealthRows& rows) const
{
    if (model_.contactPairs.empty() || !(internal_ > 0)) return;
    const double value = contact_ / internal_;
    const bool judged = counts(contact_);
    rows.push_back({"energy in contact springs / internal energy", value,
                    judged ? HealthLimits::contactSprings : 0, judged ? "" : "of little energy",
                    elastic_.time, judged && value > HealthLimits::contactSprings,
                    "contact is soft beside the bodies: a larger normalScale, or penalty series "
                    "against what is rigid"});
}

void EnergyHealth::addInertia(HealthRows& rows) const
{
    const double limit = model_.control.kineticShare;
    if (!(limit > 0)) return;
    rows.push_back(
        {"kinetic energy / energy of the elements", kineticShare_.value, limit, "",
         kineticShare_.time, kineticShare_.value > limit,
         "inertia has a part in the result: load more slowly or scale the mass less; the first "
         "waves, before quasiStatic.after, are not judged"});
}

} // namespace fpm
