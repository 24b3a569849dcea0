#include "solver/SetUp.h"
#include "solver/elements/ElementStep.h"

namespace fpm {

void scaleMass(SolverSetUp& data, const Model& model)
{
    const std::vector<double> unscaled = data.elements.mass;
    for (Index element = 0; element < data.elements.count; ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        if (part.massFactor == 1 && !(part.targetStep > 0)) continue;
        double& mass =
            data.elements.mass[data.elements.tileOf(element)
                               + std::size_t(data.elements.placeInPatch[std::size_t(element)])];
        const double own = mass;
        mass *= part.massFactor;
        if (part.targetStep > 0) {
            // The step grows with the square root of the mass.
            const double ratio =
                part.targetStep / stableStep(part, cornersOf(model.mesh, element), mass);
            if (ratio > 1) mass *= ratio * ratio;
        }
        data.elements.scaled += mass > own;
    }
    if (!data.elements.heats || data.elements.scaled == 0) return;
    for (std::size_t i = 0; i < unscaled.size(); ++i)
        data.elements.massRatio.push_back(unscaled[i] > 0 ? data.elements.mass[i] / unscaled[i]
                                                          : 1);
}

} // namespace fpm
