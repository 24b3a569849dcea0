#include "solver/elements/ElementStep.h"

#include <algorithm>

namespace fpm {

namespace {

/// An element whose points are never stored: all are at rest without stress.
struct NoState {
    void read(int, ElementState<double>& to) const { to = {}; }
    void store(int, const ElementState<double>&, const ElementStep<double>&) const {}
};

Modes<double> modesOf(const std::array<Point, 8>& corners)
{
    Modes<double> x{};
    for (std::size_t c = 0; c < 3; ++c) {
        double corner[8], modes[8];
        for (std::size_t i = 0; i < 8; ++i) corner[i] = corners[i][c] - corners[0][c];
        toModes(corner, modes);
        for (int m = 1; m < 8; ++m)
            (c == 0 ? x.mode[m].x : c == 1 ? x.mode[m].y : x.mode[m].z) = modes[m];
    }
    return x;
}

} // namespace

double stableStep(const Part& part, const std::array<Point, 8>& corners, double mass)
{
    const MaterialConstants<double> m = materialConstants(part);
    const Modes<double> x = modesOf(corners);
    Modes<double> still{};
    if (part.hexahedron == HexahedronForm::selective)
        return updateSelective<Elastic>(m, x, still, mass, 0.0, NoState{}).stableTimeStep;
    ElementState<double> state{};
    return updateHexahedron<Elastic, StiffnessHourglass>(m, x, still, mass, 0.0, 0.5, state)
        .stableTimeStep;
}

std::array<Point, 8> cornersOf(const Mesh& mesh, Index element)
{
    std::array<Point, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = mesh.points[std::size_t(mesh.hexahedra[std::size_t(element)][i])];
    return corners;
}

double firstElementStep(const ElementSetUp& elements, const Model& model)
{
    double least = 1e300;
    for (Index element = 0; element < elements.count; ++element) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(element))];
        if (isRigid(part.kind)) continue;
        least = std::min(
            least, stableStep(part, cornersOf(model.mesh, element), elements.massOf(element)));
    }
    return least;
}

} // namespace fpm
