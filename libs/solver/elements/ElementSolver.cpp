#include "solver/elements/ElementSolver.h"

#include "base/Hash.h"

#include <cstring>

namespace fpm {

float floatAt(const void* memory, std::size_t i)
{
    float value;
    std::memcpy(&value, static_cast<const std::byte*>(memory) + i * sizeof value, sizeof value);
    return value;
}

void ElementSolver::updateForces()
{
    backend_.timed(seconds_, [this] { launches_.forces(); });
}

ElementValues ElementSolver::values() const
{
    backend_.synchronize();
    const std::vector<double> state = fields_.state.toDoubles(),
                              sums = fields_.plasticStrain.toDoubles();
    ElementValues out;
    for (Index element = 0; element < setUp_.count; ++element) {
        const ElementPlace place = setUp_.placeOf(element);
        const StateLayout& layout = setUp_.layouts[place.part];
        // Mean over the integration points.
        const auto mean = [&](const std::vector<double>& values, std::size_t first, int step,
                              int count) {
            double sum = 0;
            for (int point = 0; point < count; ++point)
                sum += values[first + std::size_t(step * point) * std::size_t(tileWidth)];
            return count > 0 ? sum / count : 0.0;
        };
        const double strain = mean(sums, place.strains, 1, layout.strains());
        const bool deleted = isDeleted(strain);
        for (std::size_t k = 0; k < 6; ++k)
            out.stress.push_back(
                deleted ? 0
                        : mean(state, place.state + k * std::size_t(tileWidth), 6, layout.points));
        out.plasticStrain.push_back(plasticStrainOf(strain));
        out.deleted.push_back(deleted);
        out.eroded.push_back(deleted ? state[place.state] : 0);
        if (!setUp_.heats) continue;
        const std::size_t rise =
            place.strains + std::size_t(layout.temperature(0)) * std::size_t(tileWidth);
        out.temperature.push_back(setUp_.materials[place.part].general.temperature
                                  + mean(sums, rise, 1, layout.heats ? layout.points : 0));
    }
    return out;
}

StateValues ElementSolver::state() const
{
    backend_.synchronize();
    return {fields_.state.toDoubles(), fields_.plasticStrain.toDoubles()};
}

std::uint64_t ElementSolver::checksum(std::uint64_t hash) const
{
    const std::vector<std::byte> state = fields_.state.image(),
                                 sums = fields_.plasticStrain.image();
    const auto add = [&](const std::vector<std::byte>& memory, std::size_t valueBytes,
                         std::size_t i) {
        hash = hashedBytes(hash, memory.data() + i * valueBytes, valueBytes);
    };
    for (Index element = 0; element < setUp_.count; ++element) {
        const ElementPlace place = setUp_.placeOf(element);
        const StateLayout& layout = setUp_.layouts[place.part];
        const int wide = layout.floatHourglass ? layout.hourglassForces() : layout.size();
        for (std::size_t k = 0; k < std::size_t(wide); ++k)
            add(state, fields_.state.valueBytes(), place.state + k * std::size_t(tileWidth));
        for (int k = 0; layout.floatHourglass && k < layout.hourglass; ++k)
            add(state, sizeof(float), inFloatTiles(place.state, wide, k));
        for (std::size_t k = 0; k < std::size_t(layout.sums()); ++k)
            add(sums, fields_.plasticStrain.valueBytes(),
                place.strains + k * std::size_t(tileWidth));
    }
    return hash;
}

} // namespace fpm
