#include "run/StepSetters.h"

#include "base/Format.h"
#include "solver/elements/ElementStep.h"

#include <algorithm>

namespace fpm {

namespace {

/// Mass that elements would gain so that none has a smaller stable step, over that of all.
double
addedShare(const std::vector<double>& steps, const std::vector<double>& masses, double target)
{
    double added = 0, all = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!(steps[i] > 0)) continue;
        all += masses[i];
        const double ratio = target / steps[i];
        if (ratio > 1) added += masses[i] * (ratio * ratio - 1);
    }
    return added / all;
}

StepSetters::Price priceOf(const std::vector<double>& steps,
                           const std::vector<double>& masses,
                           const SmallElements& few,
                           double share)
{
    double low = few.least, high = few.ordinary;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (addedShare(steps, masses, middle) > share ? high : low) = middle;
    }
    return {addedShare(steps, masses, low), low, low / few.least};
}

} // namespace

std::optional<StepSetters> stepSetters(const Solver& solver, const Model& model)
{
    std::vector<double> steps, masses;
    for (Index element = 0; element < solver.elements().setUp().count; ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        masses.push_back(solver.elements().setUp().massOf(element));
        steps.push_back(isRigid(part.kind)
                            ? 0
                            : stableStep(part, cornersOf(model.mesh, element), masses.back()));
    }
    const auto few = smallElements(model.mesh, steps);
    if (!few) return std::nullopt;
    StepSetters setters{*few, {}};
    for (const double share : {0.01, 0.05})
        setters.prices.push_back(priceOf(steps, masses, *few, share));
    return setters;
}

void reportStepSetters(const std::optional<StepSetters>& setters, Log& log)
{
    if (!setters) return;
    const SmallElements& few = setters->elements;
    log.line(format("{} set the time step: stable step {}, of most elements {}: {} times as many "
                    "steps as these would need",
                    smallElementsText(few), toText(few.least, 3), toText(few.ordinary, 3),
                    toText(few.ratio(), 3)));
    std::string remedies = "  remedies: larger elements there";
    for (const StepSetters::Price& price : setters->prices)
        if (price.saves > 1.1)
            remedies += format("; massScaling { targetStep {}; }: {} times fewer steps for {} % "
                               "more mass",
                               toText(price.targetStep, 3), toText(price.saves, 3),
                               toText(100 * price.addedMass, 2));
    log.line(remedies);
}

} // namespace fpm
