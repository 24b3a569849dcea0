#include "solver/elements/ElementFields.h"

#include <cstring>

namespace fpm {

namespace {

template <class Work>
GeneralConstants<Work> converted(const GeneralConstants<double>& g)
{
    return {g.rotation,
            Work(g.kinematicModulus),
            Work(g.powerModulus),
            Work(g.powerExponent),
            g.rateLaw,
            Work(g.referenceRate),
            Work(g.rateCoefficient),
            Work(g.heatPerWork),
            Work(g.temperature),
            Work(g.softeningExponent),
            Work(g.roomTemperature),
            Work(g.inverseMeltingRange),
            Work(g.erosionStrain),
            g.erodes,
            g.erodesInverted};
}

template <class Work>
std::vector<std::byte> bytesOf(const std::vector<MaterialConstants<double>>& materials)
{
    std::vector<std::byte> bytes(materials.size() * sizeof(MaterialConstants<Work>));
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const MaterialConstants<double>& m = materials[i];
        MaterialConstants<Work> to{Work(m.lambda),
                                   Work(m.twoMu),
                                   Work(m.threeMu),
                                   Work(m.pressureWaveModulus),
                                   Work(m.young),
                                   Work(m.poisson),
                                   Work(m.linearViscosity),
                                   Work(m.quadraticViscosity),
                                   Work(m.hourglass),
                                   Work(m.coupledHourglass),
                                   m.rows,
                                   m.floatHourglass,
                                   {},
                                   {},
                                   {},
                                   converted<Work>(m.general)};
        for (int row = 0; row < m.rows; ++row) {
            to.strain[row] = Work(m.strain[row]);
            to.stress[row] = Work(m.stress[row]);
            to.slope[row] = Work(m.slope[row]);
        }
        std::memcpy(&bytes[i * sizeof to], &to, sizeof to);
    }
    return bytes;
}

} // namespace

ElementFields::ElementFields(const ElementSetUp& setUp,
                             std::size_t interiorEnd,
                             const Memory& memory,
                             const NumberTypes& numbers)
    : FieldSet("elements", memory, numbers)
{
    patches.assign(setUp.patches);
    materials.assign(numbers.work == ValueType::float64 ? bytesOf<double>(setUp.materials)
                                                        : bytesOf<float>(setUp.materials));
    std::vector<Index> listed;
    for (const KernelGroup& group : setUp.groups) {
        groupStart.push_back(listed.size());
        listed.insert(listed.end(), group.patches.begin(), group.patches.end());
    }
    groupPatches.assign(listed);
    corners.assign(setUp.corners);
    cornerStarts.assign(setUp.cornerStarts);
    slotCorners.assign(setUp.slotCorners);
    boundaryNodes.assign(setUp.boundaryNodes);
    mass.assign(setUp.mass);
    massRatio.assign(setUp.massRatio);
    state.resize(setUp.stateSize);
    plasticStrain.resize(setUp.strainCount);
    interiorForce.resize(3 * interiorEnd);
    partialForce.resize(3 * std::size_t(setUp.partialSumCount));
    patchEnergy.resize(setUp.patches.size() * elementEnergies);
    // Patches of rigid parts have no element work: no bound comes from them.
    patchStep.assign(std::vector<double>(setUp.patches.size(), 1e30));
}

} // namespace fpm
