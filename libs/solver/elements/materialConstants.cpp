#include "solver/elements/ElementSetUp.h"

namespace fpm {

namespace {

static_assert(int(RateDependence::cowperSymonds) == int(RateLaw::cowperSymonds)
              && int(RateDependence::johnsonCook) == int(RateLaw::logarithmic));

GeneralConstants<double> generalConstants(const Part& part)
{
    GeneralConstants<double> g{};
    g.rotation = RotationRule(int(part.rotation));
    g.erodes = part.erosion.any();
    g.erodesInverted = part.erosion.inverted;
    g.erosionStrain = part.erosion.plasticStrain > 0 ? part.erosion.plasticStrain : 1e30;
    const Flow& flow = part.flow;
    g.temperature = flow.temperature;
    if (part.kind != PartKind::elastoplastic) return g;
    g.kinematicModulus = flow.kinematicModulus;
    g.powerModulus = flow.powerModulus;
    g.powerExponent = flow.powerExponent;
    g.rateLaw = RateLaw(int(flow.rate));
    g.referenceRate = flow.referenceRate;
    g.rateCoefficient = flow.rateCoefficient;
    g.heatPerWork = flow.heatFraction > 0 ? flow.heatFraction / flow.specificHeat : 0;
    g.softeningExponent = flow.softeningExponent;
    g.roomTemperature = flow.roomTemperature;
    if (flow.softeningExponent > 0)
        g.inverseMeltingRange = 1 / (flow.meltingTemperature - flow.roomTemperature);
    return g;
}

} // namespace

MaterialConstants<double> materialConstants(const Part& part)
{
    MaterialConstants<double> m{};
    const double e = part.youngsModulus, nu = part.poissonsRatio;
    const double mu = e / (2 * (1 + nu));
    m.lambda = e * nu / ((1 + nu) * (1 - 2 * nu));
    m.twoMu = 2 * mu;
    m.threeMu = 3 * mu;
    m.pressureWaveModulus = m.lambda + 2 * mu;
    m.young = e;
    m.poisson = nu;
    m.linearViscosity = part.linearBulkViscosity;
    m.quadraticViscosity = part.quadraticBulkViscosity;
    m.hourglass = part.hourglassCoefficient;
    m.coupledHourglass = part.hourglass == HourglassForm::physical
                                 && part.hourglassPlastic == HourglassPlastic::coupled
                                 && part.kind == PartKind::elastoplastic
                             ? 1
                             : 0;
    static_assert(mostHardeningRows <= std::size_t(maxHardeningRows));
    m.rows = int(part.hardening.size());
    for (int row = 0; row < m.rows; ++row) {
        const Hardening& here = part.hardening[std::size_t(row)];
        m.strain[row] = here.equivalentPlasticStrain;
        m.stress[row] = here.yieldStress;
        if (row + 1 < m.rows) {
            const Hardening& next = part.hardening[std::size_t(row) + 1];
            m.slope[row] = (next.yieldStress - here.yieldStress)
                           / (next.equivalentPlasticStrain - here.equivalentPlasticStrain);
        } else // the last slope continues
            m.slope[row] = row > 0 ? m.slope[row - 1] : 0;
    }
    m.general = generalConstants(part);
    return m;
}

bool needsGeneralPlasticity(const Part& part)
{
    return part.rotation != RotationForm::midSurface || part.hexahedron == HexahedronForm::selective
           || part.erosion.any() || (part.kind == PartKind::elastoplastic && part.flow != Flow{});
}

} // namespace fpm
