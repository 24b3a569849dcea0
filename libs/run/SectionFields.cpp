#include "run/SectionFields.h"

#include "kernels/element/Deletion.h"
#include "kernels/element/ElementKernels.h"
#include "model/PartMaterial.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// One element as the kernels have it.
struct Element {
    const MaterialConstants<double>& material;
    const StateLayout& layout;
    const StateValues& values;
    ElementPlace place;
    Modes<double> modes;

    double state(int i) const
    {
        return values.state[place.state + std::size_t(i) * std::size_t(tileWidth)];
    }
    double strain(int i) const
    {
        return values.strains[place.strains + std::size_t(i) * std::size_t(tileWidth)];
    }
    Sym3<double> tensor(int first) const
    {
        return {state(first),     state(first + 1), state(first + 2),
                state(first + 3), state(first + 4), state(first + 5)};
    }
    double hourglass(int i) const
    {
        if (!layout.floatHourglass) return state(layout.hourglassForces() + i);
        return double(
            floatAt(values.state.data(), inFloatTiles(place.state, layout.hourglassForces(), i)));
    }
    void hourglass(Vec3<double> (&out)[4]) const
    {
        for (int j = 0; j < 4; ++j)
            out[j] = {hourglass(3 * j), hourglass(3 * j + 1), hourglass(3 * j + 2)};
    }
};

Modes<double> modesOf(const Hexahedron& nodes, const std::vector<Point>& points)
{
    Modes<double> out;
    double modes[3][8];
    for (std::size_t c = 0; c < 3; ++c) {
        double corners[8];
        for (std::size_t k = 0; k < 8; ++k)
            corners[k] = points[std::size_t(nodes[k])][c] - points[std::size_t(nodes[0])][c];
        toModes(corners, modes[c]);
    }
    for (std::size_t m = 0; m < 8; ++m) out.mode[m] = {modes[0][m], modes[1][m], modes[2][m]};
    return out;
}

/// Elastic energy per volume of the forces of the stiffness form.
double stiffnessEnergy(const Element& element)
{
    const Gradient<double> gradient = meanGradient(element.modes);
    const double volume = gradient.volume64 / 64,
                 k = StiffnessHourglass::stiffness<double>(
                     element.material, gradientSquare512(gradient) / 512, 1 / volume);
    Vec3<double> q[4];
    element.hourglass(q);
    double square = 0;
    for (const Vec3<double>& one : q) square += dot(one, one);
    return k > 0 ? square / (2 * k * volume) : 0;
}

double misesOf(const Sym3<double>& s)
{
    const double mean = (s.xx + s.yy + s.zz) / 3;
    const Sym3<double> deviator{s.xx - mean, s.yy - mean, s.zz - mean, s.xy, s.yz, s.zx};
    return std::sqrt(1.5 * contract(deviator, deviator));
}

/// Strength over three times the shear modulus below which it is rounding of the stress, as at the
/// apex of a cone: there any Mises stress makes the point yield, and the ratio of two roundings
/// says nothing.
constexpr double noStrength = 1e-8;

/// The largest over the integration points.
template <class Law>
double utilisationOf(const Element& element, double bending)
{
    const MaterialConstants<double>& m = element.material;
    const StateLayout& layout = element.layout;
    double most = 0;
    for (int point = 0; point < layout.points; ++point) {
        const Sym3<double> stress = element.tensor(layout.stress(point));
        Sym3<double> shifted = stress;
        if (layout.kinematic) shifted = stress + -1.0 * element.tensor(layout.backstress(point));
        const double rise = layout.heats ? element.strain(layout.temperature(point)) : 0;
        const double yield =
            Law::template strength<double>(m, {element.strain(point), bending, rise, 0.0}, stress);
        most = std::max(most, yield > noStrength * m.threeMu
                                  ? sectionStress(misesOf(shifted), bending) / yield
                                  : 1);
    }
    return most;
}

} // namespace

SectionFields sectionFields(Solver& solver, const Model& model, const std::vector<Point>& points)
{
    const StateValues values = solver.elements().state();
    const std::size_t count = std::size_t(solver.elements().setUp().count);
    SectionFields out{std::vector<double>(count), std::vector<double>(count),
                      std::vector<double>(count)};
    for (std::size_t e = 0; e < count; ++e) {
        const ElementPlace place = solver.elements().setUp().placeOf(Index(e));
        const Part& part = model.parts[place.part];
        const StateLayout& layout = solver.elements().setUp().layouts[place.part];
        if (layout.points == 0) continue; // a rigid body
        const Element element{solver.elements().setUp().materials[place.part], layout, values,
                              place, modesOf(model.mesh.hexahedra[e], points)};
        if (layout.plastic && isDeleted(element.strain(0))) continue;
        double bending = 0;
        if (layout.hourglass > 0 && part.hourglass == HourglassForm::physical) {
            Vec3<double> c[4];
            element.hourglass(c);
            const auto section = PhysicalHourglass::present(element.material, element.modes, c);
            out.bending[e] = section.bendingEnergy / 2;
            out.hourglass[e] = section.lastEnergy / 2;
            bending = section.bending;
        } else if (layout.hourglass > 0)
            out.hourglass[e] = stiffnessEnergy(element);
        if (layout.plastic)
            visitKernel(kernelOf(part), [&]<class Law, class>() {
                if constexpr (Law::plastic)
                    out.utilisation[e] = utilisationOf<Law>(element, bending);
            });
    }
    return out;
}

} // namespace fpm
