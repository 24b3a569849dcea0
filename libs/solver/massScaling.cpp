#include "solver/ElementStep.h"

namespace fpm {

void scaleMass(SolverData& data, const Model& model)
{
    const std::vector<double> unscaled = data.elementMass;
    for (Index element = 0; element < data.elementCount; ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        if (part.massFactor == 1 && !(part.targetStep > 0)) continue;
        double& mass = data.elementMass[data.tileOf(element)
                                        + std::size_t(data.elementPlace[std::size_t(element)])];
        const double own = mass;
        mass *= part.massFactor;
        if (part.targetStep > 0) {
            // The step grows with the square root of the mass.
            const double ratio =
                part.targetStep / stableStep(part, cornersOf(model.mesh, element), mass);
            if (ratio > 1) mass *= ratio * ratio;
        }
        data.scaledElements += mass > own;
    }
    if (!data.heats || data.scaledElements == 0) return;
    for (std::size_t i = 0; i < unscaled.size(); ++i)
        data.massRatio.push_back(unscaled[i] > 0 ? data.elementMass[i] / unscaled[i] : 1);
}

} // namespace fpm
