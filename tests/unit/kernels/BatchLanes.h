#pragma once

#include "kernels/element/Hexahedron.h"
#include "kernels/material/Materials.h"
#include "parallel/Batch.h"
#include "unit/kernels/BatchCase.h"

// Included by one translation unit for each vector width; internal linkage keeps their code apart.
namespace {

using fpm::test::BatchCase;
using fpm::test::BatchOutcome;

/// Value `get(case)` of each lane.
template <class T, class Get>
T lanes(const BatchCase* cases, const Get& get)
{
    using Traits = fpm::NumberTraits<T>;
    alignas(64) typename Traits::Scalar values[Traits::lanes];
    for (int lane = 0; lane < Traits::lanes; ++lane)
        values[lane] = typename Traits::Scalar(get(cases[lane]));
    return Traits::read(values);
}

template <class T>
fpm::Vec3<T> vectorOf(const BatchCase* cases, auto member, std::size_t first)
{
    const auto component = [&](std::size_t c) {
        return lanes<T>(cases, [&](const BatchCase& e) { return (e.*member)[first + c]; });
    };
    return {component(0), component(1), component(2)};
}

template <class T>
struct Collector {
    BatchOutcome* out;
    std::size_t next = 0;
    void operator()(const T& value)
    {
        using Traits = fpm::NumberTraits<T>;
        alignas(64) typename Traits::Scalar values[Traits::lanes];
        Traits::store(values, value);
        for (int lane = 0; lane < Traits::lanes; ++lane) out[lane][next] = double(values[lane]);
        ++next;
    }
    void operator()(const fpm::Vec3<T>& v)
    {
        (*this)(v.x);
        (*this)(v.y);
        (*this)(v.z);
    }
};

/// The elements of one batch; `out` gets one outcome a lane.
template <class T, class Material, class Hourglass>
void updateLanes(const fpm::MaterialConstants<fpm::ScalarOf<T>>& material,
                 const BatchCase* cases,
                 BatchOutcome* out)
{
    using Real = fpm::ScalarOf<T>;
    fpm::Modes<T> x, w;
    for (std::size_t k = 0; k < 8; ++k) {
        x.mode[k] = vectorOf<T>(cases, &BatchCase::modes, 3 * k);
        w.mode[k] = vectorOf<T>(cases, &BatchCase::increment, 3 * k);
    }
    fpm::ElementState<T> state;
    const fpm::Vec3<T> normal = vectorOf<T>(cases, &BatchCase::stress, 0),
                       shear = vectorOf<T>(cases, &BatchCase::stress, 3);
    state.stress = {normal.x, normal.y, normal.z, shear.x, shear.y, shear.z};
    state.equivalentPlasticStrain =
        lanes<T>(cases, [](const BatchCase& e) { return e.plasticStrain; });
    for (std::size_t j = 0; j < 4; ++j)
        state.hourglass[j] = vectorOf<T>(cases, &BatchCase::hourglass, 3 * j);
    if constexpr (Material::general) {
        const fpm::Vec3<T> direct = vectorOf<T>(cases, &BatchCase::backstress, 0),
                           twist = vectorOf<T>(cases, &BatchCase::backstress, 3);
        state.backstress = {direct.x, direct.y, direct.z, twist.x, twist.y, twist.z};
        state.temperatureRise =
            lanes<T>(cases, [](const BatchCase& e) { return e.temperatureRise; });
    }
    const T mass = lanes<T>(cases, [](const BatchCase& e) { return e.mass; });
    const fpm::ElementStep<T> step = fpm::updateHexahedron<Material, Hourglass>(
        material, x, w, mass, Real(fpm::test::batchRate), Real(fpm::test::batchStrainPoint), state);

    Collector<T> collect{out};
    for (const fpm::Vec3<T>& force : w.mode) collect(force);
    const fpm::Sym3<T>& s = state.stress;
    for (const T& value : {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}) collect(value);
    for (const fpm::Vec3<T>& q : state.hourglass) collect(q);
    for (const T& value : {step.internal, step.plastic, step.hourglass, step.bulkViscosity,
                           step.plasticStrainIncrement, step.stableTimeStep})
        collect(value);
    if constexpr (Material::general) {
        const fpm::Sym3<T>& a = state.backstress;
        for (const T& value :
             {a.xx, a.yy, a.zz, a.xy, a.yz, a.zx, step.temperatureIncrement, step.deletes})
            collect(value);
    }
}

template <class Real>
fpm::MaterialConstants<Real> batchMaterial()
{
    fpm::MaterialConstants<Real> m{};
    const double young = 100, poisson = 0.3, mu = young / (2 * (1 + poisson));
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    m.lambda = Real(lambda);
    m.twoMu = Real(2 * mu);
    m.threeMu = Real(3 * mu);
    m.pressureWaveModulus = Real(lambda + 2 * mu);
    m.young = Real(young);
    m.poisson = Real(poisson);
    m.linearViscosity = Real(0.06);
    m.quadraticViscosity = Real(1.2);
    m.hourglass = Real(0.7);
    m.coupledHourglass = Real(1);
    const double strain[3] = {0, 0.01, 0.05}, stress[3] = {2, 2.5, 3};
    m.rows = 3;
    for (int row = 0; row < 3; ++row) {
        m.strain[row] = Real(strain[row]);
        m.stress[row] = Real(stress[row]);
        m.slope[row] = Real(row == 0 ? 50 : 12.5);
    }
    return m;
}

/// Runs the three hourglass forms; outcomes of a lane one after the other.
template <class T>
std::vector<BatchOutcome> outcomes(const std::vector<BatchCase>& cases)
{
    constexpr std::size_t width = std::size_t(fpm::NumberTraits<T>::lanes);
    const auto material = batchMaterial<fpm::ScalarOf<T>>();
    std::vector<BatchOutcome> all(3 * cases.size());
    BatchOutcome* out = all.data();
    for (std::size_t e = 0; e + width <= cases.size(); e += width) {
        updateLanes<T, fpm::J2Plasticity, fpm::StiffnessHourglass>(material, &cases[e], out + e);
        updateLanes<T, fpm::J2Plasticity, fpm::ViscousHourglass>(material, &cases[e],
                                                                 out + cases.size() + e);
        updateLanes<T, fpm::J2Plasticity, fpm::PhysicalHourglass>(material, &cases[e],
                                                                  out + 2 * cases.size() + e);
    }
    return all;
}

/// One material for each law, and what goes with it.
template <class Real>
std::vector<fpm::MaterialConstants<Real>> generalMaterials()
{
    std::vector<fpm::MaterialConstants<Real>> all(5, batchMaterial<Real>());
    all[0].general.kinematicModulus = Real(20);
    all[1].general.rateLaw = fpm::RateLaw::cowperSymonds;
    all[1].general.referenceRate = Real(0.1);
    all[1].general.rateCoefficient = Real(0.2);
    fpm::GeneralConstants<Real>& hot = all[2].general;
    all[2].rows = 1;
    all[2].slope[0] = Real(0);
    hot.powerModulus = Real(3);
    hot.powerExponent = Real(0.31);
    hot.rateLaw = fpm::RateLaw::logarithmic;
    hot.referenceRate = Real(0.01);
    hot.rateCoefficient = Real(0.025);
    hot.heatPerWork = Real(30);
    hot.temperature = hot.roomTemperature = Real(293);
    hot.softeningExponent = Real(1.09);
    hot.inverseMeltingRange = Real(1.0 / 1000);
    all[3].general.erodes = all[3].general.erodesInverted = true;
    all[3].general.erosionStrain = Real(0.06);
    all[4].coupledHourglass = Real(0);
    return all;
}

/// Runs every law, the hourglass forms in turn.
template <class T>
std::vector<BatchOutcome> generalOutcomes(const std::vector<BatchCase>& cases)
{
    constexpr std::size_t width = std::size_t(fpm::NumberTraits<T>::lanes);
    const auto materials = generalMaterials<fpm::ScalarOf<T>>();
    std::vector<BatchOutcome> all(materials.size() * cases.size());
    for (std::size_t law = 0; law < materials.size(); ++law) {
        BatchOutcome* out = all.data() + law * cases.size();
        for (std::size_t e = 0; e + width <= cases.size(); e += width)
            if (law % 2 == 0)
                updateLanes<T, fpm::GeneralPlasticity, fpm::PhysicalHourglass>(materials[law],
                                                                               &cases[e], out + e);
            else
                updateLanes<T, fpm::GeneralPlasticity, fpm::StiffnessHourglass>(materials[law],
                                                                                &cases[e], out + e);
    }
    return all;
}

} // namespace
