#pragma once

#include "kernels/BlockSum.h"
#include "kernels/element/SelectiveHexahedron.h"
#include "kernels/element/StateLayout.h"
#include "kernels/particle/InteriorNodes.h"
#include "parallel/Atomic.h"
#include "parallel/LaunchSizes.h"

namespace fpm {

/// Mesh patch as the element kernel receives it.
struct PatchHeader {
    Index elementCount;
    Index tile; ///< padded elements in all patches before
    Index firstNode, nodeCount;
    Index interiorCount;   ///< its first nodes, numbered consecutively: no other patch has them
    Index firstPartialSum; ///< one for each of its other nodes
    Index material;
    Index movesInterior; ///< 1: some of its interior nodes are moved with it, not by NodeMotion
    Index corners, cornerStarts, slotCorners; ///< start of the tables of its shape
    std::size_t state, strains;               ///< start of the state of the patch (StateLayout)
};

static_assert(patchCapacity == 256, "ElementForces::slotCorners keep the element in eight bits");

inline constexpr int elementEnergies = 4; ///< internal, plastic, hourglass, bulk viscosity
inline constexpr int elementSums = elementEnergies + 1; ///< and the stable step

/// Bytes of scratch for a patch of `nodes` nodes: nodes, corner forces, sums.
template <class Work>
constexpr std::size_t elementScratch(std::size_t nodes)
{
    constexpr std::size_t forces = 3 * HexahedronShape::nodes;
    return ((8 * nodes + 31) / 32 * 32 + (forces + elementSums) * patchCapacity) * sizeof(Work)
           + blockSumScratch(elementSums);
}

/// One step of the elements of a patch. Moves the interior nodes by the forces stored for them,
/// reads the patch's nodes into scratch, updates stress and internal force of each element, and
/// sums the corner forces per node in ascending element order, eq. (2) of the paper. Boundary nodes
/// get one partial sum per patch, which NodeMotion adds in patch order.
/// `Material`: see MaterialLaw; `Element`: a type with
///     Shape              its nodes and faces, such as HexahedronShape
///     word, name         of `hexahedron` in a dictionary, and in reports
///     hourglass          word of its hourglass control, null without
///     points, stateSize  integration points, and further values kept (of hourglass control)
///     everyLaw           whether every law has a kernel in it (hasKernel)
///     update             one step: its law at every point, corner forces for motions of corners
template <class Numbers, class Material, class Element>
struct ElementForces {
    using Work = typename Numbers::Work;
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Sum = typename Numbers::Sum;

    const Index* list; ///< patches of this kind
    const PatchHeader* patches;
    const MaterialConstants<Work>* materials;
    const Index* boundaryNodes;   ///< the nodes of a patch beyond the interior, as partial sums
    const std::uint16_t* corners; ///< node within the patch, 8 values per element, in tiles
    const std::uint16_t* cornerStarts; ///< element corners around a node: CSR
    const std::uint16_t* slotCorners;  ///< ... corner * patchCapacity + element, ascending element
    InteriorNodes<Numbers> nodes;      ///< all nodes of the model
    const Work* mass;                  ///< tiles of 1
    const Work* massRatio; ///< mass over mass without scaling, for the heat of plastic work; null:
                           ///< 1
    Work* state;           ///< tiles of the part's StateLayout
    Sum* plasticStrain;    ///< likewise, with the rises of temperature
    Work* partialForce;    ///< of other than interior nodes, x y z each
    double* patchEnergy;   ///< [patch][elementEnergies], running sums
    double* patchStep;     ///< [patch], stable step
    const StepClock* clock;
    std::int64_t* deletions; ///< changes when an element is deleted
    Work strainPoint;

    /// Of a GPU: with 128 registers a thread four small blocks share a multiprocessor. Eight points
    /// need twice as many, and so do doubles.
    static constexpr int threads = threadsPerSmallBlock,
                         blocksPerProcessor = sizeof(Work) == 4 && Element::points == 1 ? 4 : 2;

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        if (!clock->running) return;
        const Index number = list[block];
        const PatchHeader patch = patches[number];
        Work* places = reinterpret_cast<Work*>(team.scratch());
        Work* forces = places + (8 * std::size_t(patch.nodeCount) + 31) / 32 * 32;
        Work* sums = forces + 3 * Element::Shape::nodes * patchCapacity;
        double* partial = reinterpret_cast<double*>(sums + elementSums * patchCapacity);

        if (patch.movesInterior && clock->steps > 0) { // before the first step no forces are known
            nodes.advance(team, std::size_t(patch.firstNode), patch.interiorCount, *clock);
            team.barrier();
        }
        gatherNodes(team, patch, places);
        team.barrier();
        computeElements(team, patch, places, forces, sums);
        team.barrier();
        gatherForces(team, patch, forces);
        const Index count = patch.elementCount;
        blockSums(team, elementEnergies, count, sums, patchCapacity, partial);
        blockMinimum(team, count, sums + elementEnergies * patchCapacity,
                     partial + elementEnergies * blockSumLanes);
        team.barrier();
        double* energy = patchEnergy + elementEnergies * std::size_t(number);
        double* step = patchStep + number;
        team.forEach(elementSums, [=](Index k) {
            if (k < elementEnergies)
                energy[k] += blockSumResult(partial, k);
            else
                *step = blockMinimumResult(partial + k * blockSumLanes);
        });
    }

    FPM_KERNEL static constexpr StateLayout layoutOf(const MaterialConstants<Work>& m)
    {
        return stateLayout<Material, Element>(m, mayKeepFloats && m.floatHourglass);
    }

private:
    static constexpr bool mayKeepFloats = Element::stateSize > 0 && sizeof(Work) > sizeof(float);

    /// Coordinates relative to the patch's first node, and increments: the only place where
    /// positions are read, subtracted in Position and kept in Work.
    template <class Team>
    FPM_KERNEL void gatherNodes(const Team& team, const PatchHeader& patch, Work* places) const
    {
        const Index first = patch.firstNode, interior = patch.interiorCount;
        const Index* others = boundaryNodes + (patch.firstPartialSum - interior);
        const Index count = patch.nodeCount;
        const std::size_t origin = std::size_t(first), planes = nodes.nodeStride;
        const Motion dt = Motion(clock->step);
        const Position* x = nodes.position;
        const Motion* v = nodes.velocity;
        team.forEach(count, [=](Index i) {
            const std::size_t node = std::size_t(i < interior ? first + i : others[i]);
            Work *place = places + 4 * i, *increment = places + 4 * (count + i);
            for (int c = 0; c < 3; ++c) {
                const std::size_t plane = c * planes;
                place[c] = difference<Work>(x[plane + node], x[plane + origin]);
                increment[c] = Work(dt * v[plane + node]);
            }
        });
    }

    template <class Team>
    FPM_KERNEL void computeElements(const Team& team,
                                    const PatchHeader& patch,
                                    const Work* places,
                                    Work* forces,
                                    Work* sums) const
    {
        using T = typename Team::template Number<Work>;
        const MaterialConstants<Work>& m = materials[patch.material];
        const Work rate = clock->step > 0 ? Work(1 / clock->step) : Work(0);
        const Index count = patch.nodeCount;
        const std::size_t tile = std::size_t(patch.tile);
        team.template forEachBatch<Work>(patch.elementCount, [&](Index e) {
            Modes<T> x, w;
            const std::uint16_t* corner =
                corners + std::size_t(patch.corners) + inTiles(e, Element::Shape::nodes);
            gatherModes(places, corner, x);
            gatherModes(places + 4 * count, corner, w);
            const ElementStep<T> step =
                Element::template update<Material>(m, x, w, read<T>(mass + tile + e), rate,
                                                   strainPoint, PointStates{*this, m, patch, e});
            storeForces(w, forces + e);
            store(sums + e, step.internal);
            store(sums + patchCapacity + e, step.plastic);
            store(sums + 2 * patchCapacity + e, step.hourglass);
            store(sums + 3 * patchCapacity + e, step.bulkViscosity);
            store(sums + 4 * patchCapacity + e, step.stableTimeStep);
            if constexpr (Material::general)
                if (m.general.erodes && NumberTraits<T>::any(step.deletes > T(Work(0))))
                    atomicAdd64(deletions, 1);
        });
    }

    /// State of the Gauss points of one batch of elements in memory.
    struct PointStates {
        const ElementForces& kernel;
        const MaterialConstants<Work>& m;
        const PatchHeader& patch;
        Index e;

        template <class T>
        FPM_KERNEL void read(int point, ElementState<T>& to) const
        {
            kernel.readState(m, to, patch, e, point);
        }
        template <class T>
        FPM_KERNEL void
        store(int point, const ElementState<T>& from, const ElementStep<T>& step) const
        {
            kernel.storeState(m, from, step, patch, e, point);
        }
    };

    template <class T>
    FPM_KERNEL static void
    gatherModes(const Work* places, const std::uint16_t* corner, Modes<T>& out)
    {
        T x[8], y[8], z[8], m[8];
        for (int i = 0; i < 8; ++i) gather<T>(places, corner + i * tileWidth, x[i], y[i], z[i]);
        toModes(x, m);
        for (int k = 1; k < 8; ++k) out.mode[k].x = m[k];
        toModes(y, m);
        for (int k = 1; k < 8; ++k) out.mode[k].y = m[k];
        toModes(z, m);
        for (int k = 1; k < 8; ++k) out.mode[k].z = m[k];
    }

    template <class T>
    FPM_KERNEL static Sym3<T> readTensor(const Work* s)
    {
        return {read<T>(s),
                read<T>(s + tileWidth),
                read<T>(s + 2 * tileWidth),
                read<T>(s + 3 * tileWidth),
                read<T>(s + 4 * tileWidth),
                read<T>(s + 5 * tileWidth)};
    }
    template <class T>
    FPM_KERNEL static void storeTensor(Work* s, const Sym3<T>& from)
    {
        store(s, from.xx);
        store(s + tileWidth, from.yy);
        store(s + 2 * tileWidth, from.zz);
        store(s + 3 * tileWidth, from.xy);
        store(s + 4 * tileWidth, from.yz);
        store(s + 5 * tileWidth, from.zx);
    }

    template <class T>
    FPM_KERNEL void readState(const MaterialConstants<Work>& m,
                              ElementState<T>& to,
                              const PatchHeader& patch,
                              Index e,
                              int point) const
    {
        const StateLayout layout = layoutOf(m);
        const Work* first = state + patch.state + inTiles(e, layout.size());
        // Prefetch the same entry of the next tile: consecutive loads have no constant stride that
        // a processor could predict.
        if (NumberTraits<T>::lanes > 1 && point == 0)
            for (int k = 0; k < layout.size(); ++k)
                prefetch(first + (layout.size() + k) * tileWidth);
        const Sum* sums = plasticStrain + patch.strains + inTiles(e, layout.sums());
        to.stress = readTensor<T>(first + layout.stress(point) * tileWidth);
        to.equivalentPlasticStrain =
            layout.plastic ? read<T>(sums + point * tileWidth) : T(Work(0));
        if constexpr (Material::general) {
            to.backstress =
                Sym3<T>{T(Work(0)), T(Work(0)), T(Work(0)), T(Work(0)), T(Work(0)), T(Work(0))};
            to.temperatureRise = T(Work(0));
            if (layout.kinematic)
                to.backstress = readTensor<T>(first + layout.backstress(point) * tileWidth);
            if (layout.heats)
                to.temperatureRise = read<T>(sums + layout.temperature(point) * tileWidth);
        }
        if constexpr (mayKeepFloats)
            if (layout.floatHourglass) {
                readHourglass(floatForces(patch, layout, e), to.hourglass);
                return;
            }
        if constexpr (Element::stateSize > 0)
            readHourglass(first + layout.hourglassForces() * tileWidth, to.hourglass);
    }

    /// Start of the hourglass forces of an element that are stored as floats.
    FPM_KERNEL float*
    floatForces(const PatchHeader& patch, const StateLayout& layout, Index e) const
    {
        return reinterpret_cast<float*>(state)
               + inFloatTiles(patch.state + inTiles(e, layout.size()), layout.hourglassForces(), 0);
    }
    template <class T, class Stored>
    FPM_KERNEL static void readHourglass(const Stored* q, Vec3<T> (&to)[4])
    {
        for (int j = 0; j < 4; ++j)
            to[j] = {read<T>(q + 3 * j * tileWidth), read<T>(q + (3 * j + 1) * tileWidth),
                     read<T>(q + (3 * j + 2) * tileWidth)};
    }
    template <class T, class Stored>
    FPM_KERNEL static void storeHourglass(Stored* q, const Vec3<T> (&from)[4])
    {
        for (int j = 0; j < 4; ++j) {
            store(q + 3 * j * tileWidth, from[j].x);
            store(q + (3 * j + 1) * tileWidth, from[j].y);
            store(q + (3 * j + 2) * tileWidth, from[j].z);
        }
    }

    template <class T>
    FPM_KERNEL void storeState(const MaterialConstants<Work>& m,
                               const ElementState<T>& from,
                               const ElementStep<T>& step,
                               const PatchHeader& patch,
                               Index e,
                               int point) const
    {
        const StateLayout layout = layoutOf(m);
        Work* first = state + patch.state + inTiles(e, layout.size());
        Sum* sums = plasticStrain + patch.strains + inTiles(e, layout.sums());
        storeTensor(first + layout.stress(point) * tileWidth, from.stress);
        if (layout.plastic) accumulate(sums + point * tileWidth, step.plasticStrainIncrement);
        if constexpr (Material::general) {
            if (layout.kinematic)
                storeTensor(first + layout.backstress(point) * tileWidth, from.backstress);
            if (layout.heats)
                accumulate(sums + layout.temperature(point) * tileWidth,
                           massRatio
                               ? read<T>(massRatio + patch.tile + e) * step.temperatureIncrement
                               : step.temperatureIncrement);
        }
        if constexpr (mayKeepFloats)
            if (layout.floatHourglass) {
                storeHourglass(floatForces(patch, layout, e), from.hourglass);
                return;
            }
        if constexpr (Element::stateSize > 0)
            storeHourglass(first + layout.hourglassForces() * tileWidth, from.hourglass);
    }

    /// Corner forces into scratch: [3 * corner + component][patchCapacity].
    template <class T>
    FPM_KERNEL static void storeForces(const Modes<T>& f, Work* forces)
    {
        T m[8], c[8];
        for (int k = 0; k < 8; ++k) m[k] = f.mode[k].x;
        toCorners(m, c);
        for (int i = 0; i < 8; ++i) store(forces + (3 * i) * patchCapacity, c[i]);
        for (int k = 0; k < 8; ++k) m[k] = f.mode[k].y;
        toCorners(m, c);
        for (int i = 0; i < 8; ++i) store(forces + (3 * i + 1) * patchCapacity, c[i]);
        for (int k = 0; k < 8; ++k) m[k] = f.mode[k].z;
        toCorners(m, c);
        for (int i = 0; i < 8; ++i) store(forces + (3 * i + 2) * patchCapacity, c[i]);
    }

    template <class Team>
    FPM_KERNEL void
    gatherForces(const Team& team, const PatchHeader& patch, const Work* forces) const
    {
        const std::uint16_t* start = cornerStarts + patch.cornerStarts;
        const std::uint16_t* entries = slotCorners + patch.slotCorners;
        const Index interior = patch.interiorCount;
        Work* inside = nodes.force + patch.firstNode;
        Work* others = partialForce + 3 * (std::size_t(patch.firstPartialSum) - interior);
        const std::size_t planes = nodes.forceStride;
        team.forEach(patch.nodeCount, [=](Index i) {
            Work x = 0, y = 0, z = 0;
            for (Index k = start[i]; k < start[i + 1]; ++k) {
                const int entry = entries[k];
                const Work* f = forces + 3 * (entry >> 8) * patchCapacity + (entry & 255);
                x += f[0];
                y += f[patchCapacity];
                z += f[2 * patchCapacity];
            }
            Work* out = i < interior ? inside + i : others + 3 * i;
            const std::size_t next = i < interior ? planes : 1;
            out[0] = x;
            out[next] = y;
            out[2 * next] = z;
        });
    }
};

} // namespace fpm
