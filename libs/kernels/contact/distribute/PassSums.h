#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/contact/law/KinematicContact.h"

namespace fpm {

/// Energies stored and dissipated by a pass, and its resultant. Order of the sums in
/// PassSums::blockSum.
enum PassSum {
    sumSpringEnergy,
    sumTouching, ///< contactors in contact
    sumDissipated,
    sumDamped,
    sumSurfaceWork,
    sumInjected,
    sumForce, ///< of the contactors: x y z
    passSums = sumForce + 3
};

/// Sums the values kept per contactor; one block = contactBlock of them, as BlockForce.
struct PassSums {
    Index count;
    const double *springEnergy, *dissipated, *damped, *surfaceWork, *injected; ///< null: none
    const double* surfaceForce;     ///< of an analytic surface, three planes; null: of faces
    const double* reading;          ///< of one that is met exactly, see SurfaceReading; then there
                                    ///< is no spring
    const std::int64_t* blockForce; ///< of faces, see BlockForce; null: of an analytic surface
    ForceScale scale;
    double* blockSum; ///< [block][passSums]

    static constexpr std::size_t scratch()
    {
        return passSums * contactBlock * sizeof(double) + blockSumScratch(passSums);
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + passSums * contactBlock;
        const Index first = number * contactBlock,
                    size = count - first < contactBlock ? count - first : contactBlock;
        team.forEach(size, [&](Index i) { fetch(std::size_t(first + i), values + i); });
        team.barrier();
        blockSums(team, passSums, size, values, contactBlock, partial);
        team.barrier();
        double* out = blockSum + std::size_t(number) * passSums;
        team.forEach(passSums, [&](Index k) {
            out[k] = k >= sumForce && blockForce ? forceOf(number, k - sumForce)
                                                 : blockSumResult(partial, k);
        });
    }

private:
    FPM_KERNEL void fetch(std::size_t i, double* out) const
    {
        const double* const from[] = {springEnergy, nullptr,     dissipated,
                                      damped,       surfaceWork, injected};
        for (int k = 0; k < sumForce; ++k) out[k * contactBlock] = from[k] ? from[k][i] : 0;
        for (int c = 0; c < 3; ++c)
            out[(sumForce + c) * contactBlock] =
                surfaceForce ? surfaceForce[std::size_t(c) * std::size_t(count) + i] : 0;
        if (reading)
            fetchReading(i, out);
        else
            out[sumTouching * contactBlock] = springEnergy[i] > 0 ? 1 : 0;
    }
    FPM_KERNEL void fetchReading(std::size_t i, double* out) const
    {
        const auto read = [&](int k) { return reading[std::size_t(k) * std::size_t(count) + i]; };
        const Vec3<double> force{read(readForce), read(readForce + 1), read(readForce + 2)};
        out[sumTouching * contactBlock] = dot(force, force) > 0 ? 1 : 0;
        out[sumDissipated * contactBlock] += read(readDissipated);
        out[sumDamped * contactBlock] += read(readImpact);
        out[sumSurfaceWork * contactBlock] += read(readWork);
        out[sumForce * contactBlock] = force.x;
        out[(sumForce + 1) * contactBlock] = force.y;
        out[(sumForce + 2) * contactBlock] = force.z;
    }
    FPM_KERNEL double forceOf(Index number, Index c) const
    {
        std::int64_t sum = 0;
        for (Index part = 0; part < BlockForce::parts; ++part)
            sum += blockForce[std::size_t(number) * BlockForce::values + std::size_t(3 * part + c)];
        return scale.toForce(sum);
    }
};

} // namespace fpm
