#include "advise/PilotAdvice.h"

#include "advise/StaticAdvice.h"
#include "base/Format.h"
#include "mesh/Surface.h"
#include "model/NodeSelection.h"
#include "model/PartMaterial.h"

#include <algorithm>
#include <map>

namespace fpm {

namespace {

const std::string partFile = "constant/partProperties", contactFile = "system/contactDict";
constexpr double rigidShare = 0.02;    ///< of the largest deviation of any part
constexpr double yieldShare = 0.5;     ///< of the first yield stress
constexpr double energyNothing = 1e-4; ///< of the largest energy

std::string percent(double share)
{
    return toText(100 * share, 3) + " %";
}

class PilotAdviser
{
public:
    PilotAdviser(const Model& model, const Case& theCase, const Results& results)
        : model_(model),
          case_(theCase),
          results_(results)
    {
        const double end = model.control.endTime;
        seen_ = format("{} frames up to {}", results.frames, results.lastTime);
        if (results.lastTime < end * (1 - 1e-6)) seen_ += format(" of {}", end);
    }

    std::vector<Advice> all()
    {
        rigid();
        elastic();
        pairs();
        if (results_.energies) works();
        precision();
        return std::move(advice_);
    }

private:
    /// A part that conditions, bonds or velocities of single nodes hold cannot become rigid by one
    /// word.
    bool isLoose(Index part) const
    {
        const std::vector<Index> nodes = nodesOfPart(model_.mesh, part);
        const auto belongs = [&](Index node) {
            return std::binary_search(nodes.begin(), nodes.end(), node);
        };
        const auto touches = [&](const std::vector<Index>& others) {
            return std::any_of(others.begin(), others.end(), belongs);
        };
        for (const BoundaryCondition& condition : model_.boundaryConditions)
            if (condition.kind != BoundaryCondition::Kind::gravity && touches(condition.nodes))
                return false;
        for (const InitialVelocity& initial : model_.initialVelocities)
            if (initial.part != part && touches(initial.nodes)) return false;
        for (Index other = 0; other < Index(model_.parts.size()); ++other)
            if (other != part && touches(nodesOfPart(model_.mesh, other))) return false;
        return !meetsRigid(part);
    }

    bool meetsRigid(Index part) const
    {
        const auto isOf = [&](const std::vector<ElementSide>& sides, auto&& wanted) {
            return std::any_of(sides.begin(), sides.end(), [&](const ElementSide& side) {
                return wanted(model_.mesh.partOf(side.element));
            });
        };
        const auto itself = [&](Index p) { return p == part; };
        const auto rigid = [&](Index p) {
            return p != part && isRigid(model_.parts[std::size_t(p)].kind);
        };
        for (const ContactSurfaces& s : model_.mesh.contact)
            if ((isOf(s.contactorSides, itself)
                 && (s.targetSides.empty() || isOf(s.targetSides, rigid)))
                || (isOf(s.targetSides, itself) && isOf(s.contactorSides, rigid)))
                return true;
        return false;
    }

    /// Model words of the parts named; those that take theirs from another part keep what they
    /// have.
    CaseEdits models(const std::map<std::string, std::string>& words) const
    {
        CaseEdits edits;
        const Dictionary parts = case_.dictionary(partFile).sub("parts");
        for (const Part& part : model_.parts) {
            const auto wanted = words.find(part.name);
            if (wanted != words.end())
                edits.set(partFile, "parts." + part.name + ".model", wanted->second);
            else if (!parts.sub(part.name).has("model"))
                edits.keep(partFile, "parts." + part.name + ".model", wordOf(part.kind));
        }
        return edits;
    }

    /// A rigid part has no use for what its elements had.
    CaseEdits rigidEdits(const std::string& name) const
    {
        static const std::vector<std::string> kept{"model", "like", "density", "youngsModulus",
                                                   "poissonsRatio"};
        CaseEdits edits = models({{name, "rigidFree"}});
        const Dictionary part = case_.dictionary(partFile).sub("parts").sub(name);
        for (const std::string& key : part.keys())
            if (std::find(kept.begin(), kept.end(), key) == kept.end())
                edits.remove(partFile, "parts." + name + "." + key, key + ": of a deformable part");
        return edits;
    }

    /// Others that take entries from this part would lose them with it.
    bool isLent(const std::string& name) const
    {
        const Dictionary parts = case_.dictionary(partFile).sub("parts");
        return std::any_of(model_.parts.begin(), model_.parts.end(), [&](const Part& part) {
            return parts.sub(part.name).wordOr("like", "") == name;
        });
    }

    void rigid()
    {
        double most = 0;
        for (const PartExtremes& part : results_.parts) most = std::max(most, part.deviation);
        for (std::size_t p = 0; p < model_.parts.size(); ++p) {
            const Part& part = model_.parts[p];
            const PartExtremes& seen = results_.parts[p];
            if (isRigid(part.kind) || !(most > 0) || !isLoose(Index(p)) || isLent(part.name))
                continue;
            if (seen.plasticStrain > 0 || seen.deviation > rigidShare * most) continue;
            const double all = double(model_.mesh.hexahedra.size());
            advice_.push_back(
                {"rigid", format("part {} may be rigidFree", part.name),
                 format("it departs from a rigid motion by {} (rms), {} of what the part that "
                        "deforms most does, and does not yield ({})",
                        seen.deviation, percent(seen.deviation / most), seen_),
                 format("its elements ({} % of all), and its time step where it is the shortest",
                        toText(100 * model_.mesh.parts[p].elementCount / all, 3)),
                 "stress waves in it are lost, the other side alone gives the contact stiffness; "
                 "-measure shows how much that is",
                 rigidEdits(part.name), false});
            advice_.back().part = part.name;
        }
    }

    void elastic()
    {
        for (std::size_t p = 0; p < model_.parts.size(); ++p) {
            const Part& part = model_.parts[p];
            const PartExtremes& seen = results_.parts[p];
            if (part.kind != PartKind::elastoplastic || part.hardening.empty()) continue;
            const double yield = part.hardening.front().yieldStress;
            const bool plain = !part.erosion.any() && part.flow.softeningExponent == 0
                               && part.flow.heatFraction == 0;
            if (!plain || seen.plasticStrain > 0 || seen.mises > yieldShare * yield) continue;
            advice_.push_back(
                {"elastic", format("part {} stays elastic", part.name),
                 format("Mises at most {}, {} of the first yield stress {}, no plastic strain ({})",
                        seen.mises, percent(seen.mises / yield), yield, seen_),
                 format("radial return and plastic state of {} elements; -measure shows it",
                        model_.mesh.parts[p].elementCount),
                 "none while it does not yield; what happens between the frames was not seen",
                 models({{part.name, "elastic"}}), false});
            advice_.back().part = part.name;
        }
    }

    /// Swept boxes, widened by what the fastest node goes between two frames, and after the last.
    void pairs()
    {
        const double left = std::max(0.0, model_.control.endTime - results_.lastTime);
        const double margin = results_.fastest * (results_.longestStep + left);
        for (const ContactPair& pair : model_.contactPairs) {
            if (pair.kind != ContactKind::pair || pair.surface >= 0) continue;
            Point low[2], high[2];
            const std::vector<Index> nodes[2] = {pair.contactorNodes,
                                                 nodesOf(model_.mesh, pair.targetSides)};
            for (int side = 0; side < 2; ++side) {
                low[side].fill(1e300);
                high[side].fill(-1e300);
                for (const Index node : nodes[side])
                    for (std::size_t c = 0; c < 3; ++c) {
                        low[side][c] = std::min(low[side][c], results_.low[std::size_t(node)][c]);
                        high[side][c] =
                            std::max(high[side][c], results_.high[std::size_t(node)][c]);
                    }
            }
            double gap = 0;
            for (std::size_t c = 0; c < 3; ++c)
                gap = std::max({gap, low[0][c] - high[1][c], low[1][c] - high[0][c]});
            if (!(gap > 2 * margin)) continue;
            Advice one{"pairs",
                       format("pair {} does not meet", pair.name),
                       format("the boxes its surfaces sweep stay {} apart, more than twice the "
                              "displacement {} of the fastest node outside of the frames ({})",
                              gap, margin, seen_),
                       format("search and tracking of {} contactors", pair.contactorNodes.size()),
                       "none while no node is faster than in these frames",
                       {},
                       false};
            one.edits.remove(contactFile, "pairs." + pair.name,
                             format("{}: does not meet", pair.name));
            advice_.push_back(std::move(one));
        }
    }

    /// Work over the largest energy; 0 where there is none.
    double share(double work) const
    {
        const double most = largestEnergy(*results_.energies);
        return most > 0 ? work / most : 0;
    }

    void works()
    {
        for (std::size_t pair = 0; pair < model_.contactPairs.size(); ++pair)
            friction(model_.contactPairs[pair], results_.frictionWork[pair]);
        viscosity(share(largest(*results_.energies, "bulkViscosity")));
        const double damped = share(largest(*results_.energies, "damping"));
        if (!(model_.control.massDamping > 0) || damped > energyNothing) return;
        Advice one{"damping",
                   "massDamping 0",
                   format("its work is {} of the largest energy ({})", percent(damped), seen_),
                   "a product a node and step; -measure shows it",
                   "what little it damps stays",
                   {},
                   false};
        one.edits.set("system/controlDict", "massDamping", "0");
        advice_.push_back(std::move(one));
    }

    void friction(const ContactPair& pair, const std::optional<double>& work)
    {
        if (!(pair.friction > 0) || pair.kind == ContactKind::general || !work) return;
        if (share(*work) > energyNothing) return;
        Advice one{
            "friction",
            format("friction of pair {} does no work", pair.name),
            format("it dissipates {} of the largest energy ({})", percent(share(*work)), seen_),
            format("the tangential force of {} contactors; -measure shows it",
                   pair.contactorNodes.size()),
            "sticking does no work either and may be what holds the scene: trust -measure "
            "alone",
            {},
            true};
        one.edits.remove(contactFile, "pairs." + pair.name + ".friction", "friction: did no work");
        advice_.push_back(std::move(one));
    }

    void viscosity(double worked)
    {
        Advice one{"viscosity",
                   "bulkViscosity 0",
                   format("its work is {} of the largest energy ({})", percent(worked), seen_),
                   "a few products an element and step, and the part of the time step it costs; "
                   "-measure shows it",
                   "shocks ring more",
                   {},
                   false};
        bool any = false;
        for (const Part& part : model_.parts) {
            if (isRigid(part.kind)) continue;
            any |= part.linearBulkViscosity > 0 || part.quadraticBulkViscosity > 0;
            const std::string path = "parts." + part.name + ".bulkViscosity.";
            one.edits.set(partFile, path + "linear", "0");
            one.edits.set(partFile, path + "quadratic", "0");
        }
        if (any && worked <= energyNothing) advice_.push_back(std::move(one));
    }

    void precision()
    {
        if (model_.control.precision != Precision::double_) return;
        Advice one{"precision",
                   "precision mixed",
                   "state in double, work in single: often enough; only a comparison shows it",
                   "up to half the time where memory or vector width limits; -measure shows it",
                   "rounding of single precision in strain increments and forces",
                   {},
                   true};
        one.edits.set("system/controlDict", "precision", "mixed");
        advice_.push_back(std::move(one));
    }

    const Model& model_;
    const Case& case_;
    const Results& results_;
    std::string seen_;
    std::vector<Advice> advice_;
};

} // namespace

std::vector<Advice> pilotAdvice(const Model& model, const Case& theCase, const Results& results)
{
    return PilotAdviser(model, theCase, results).all();
}

} // namespace fpm
