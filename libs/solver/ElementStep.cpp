#include "solver/ElementStep.h"

#include "kernels/element/Gradient.h"
#include "mesh/Quality.h"
#include "solver/SolverData.h"

#include <algorithm>
#include <cmath>

namespace fpm {

double elementStep(const Part& part, double mass, const std::array<Point, 8>& corners)
{
    Modes<double> x{};
    for (std::size_t c = 0; c < 3; ++c) {
        double corner[8], modes[8];
        for (std::size_t i = 0; i < 8; ++i) corner[i] = corners[i][c];
        toModes(corner, modes);
        for (int m = 1; m < 8; ++m)
            (c == 0 ? x.mode[m].x : c == 1 ? x.mode[m].y : x.mode[m].z) = modes[m];
    }
    const Gradient<double> gradient = meanGradient(x);
    const double volume = gradient.volume64 / 64, square = gradientSquare512(gradient) / 512;
    if (!(volume > 0)) return -1;
    const double modulus = materialConstants(part).pressureWaveModulus;
    const double z = part.linearBulkViscosity;
    return std::sqrt(mass * volume / (2 * modulus * square)) * (std::sqrt(1 + z * z) - z);
}

double firstElementStep(const Model& model)
{
    double least = 1e300;
    for (Index element = 0; element < Index(model.mesh.hexahedra.size()); ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        if (part.kind == PartKind::rigid) continue;
        std::array<Point, 8> corners;
        for (std::size_t i = 0; i < 8; ++i)
            corners[i] =
                model.mesh.points[std::size_t(model.mesh.hexahedra[std::size_t(element)][i])];
        least =
            std::min(least, elementStep(part, part.density * volume(model.mesh, element), corners));
    }
    return least;
}

} // namespace fpm
