#pragma once

#include "kernels/element/ElementForces.h"
#include "mesh/Patches.h"
#include "model/Model.h"

namespace fpm {

/// Patches that share a kernel: same material law and element.
struct KernelGroup {
    PartKind kind;
    bool general; ///< GeneralPlasticity, whatever the kind
    HexahedronForm hexahedron;
    HourglassForm hourglass; ///< without meaning for selective
    std::vector<Index> patches;
};

/// Where the state of one element lies: first value of it and of its plastic strains; further
/// values follow tileWidth apart.
struct ElementPlace {
    std::size_t part, state, strains;
};

/// Patches of elements with their materials, in the layout of the kernels.
struct ElementSetUp {
    Index count = 0, padded = 0; ///< padded: patches filled up to whole tiles
    Index partialSumCount = 0;
    std::size_t maxPatchNodes = 0;
    std::vector<PatchHeader> patches;
    std::vector<KernelGroup> groups;
    std::vector<MaterialConstants<double>> materials;
    std::vector<StateLayout> layouts;           ///< of each part
    std::size_t stateSize = 0, strainCount = 0; ///< of all patches together
    std::vector<std::uint16_t> corners, cornerStarts,
        slotCorners;                  ///< see PatchTables, ElementForces
    std::vector<Index> boundaryNodes; ///< node of each partial sum
    std::vector<double> mass;         ///< tiles of 1
    std::vector<double> massRatio;    ///< of it to the mass that is heated; empty: 1
    std::size_t scaled = 0;           ///< elements with scaled mass
    bool rigidParts = false;
    bool erodes = false, heats = false; ///< some part does

    std::vector<std::size_t> tileStart; ///< of the element's patch; here and below: [element]
    std::vector<Index> placeInPatch, patchOf;

    /// Position of element e (mesh order) in tiles: tile and place.
    std::size_t tileOf(Index element) const { return tileStart[std::size_t(element)]; }
    ElementPlace placeOf(Index element) const
    {
        const PatchHeader& patch = patches[std::size_t(patchOf[std::size_t(element)])];
        const StateLayout& layout = layouts[std::size_t(patch.material)];
        const Index e = placeInPatch[std::size_t(element)];
        return {std::size_t(patch.material), patch.state + inTiles(e, layout.size()),
                patch.strains + inTiles(e, layout.sums())};
    }
    double massOf(Index element) const
    {
        return mass[tileOf(element) + std::size_t(placeInPatch[std::size_t(element)])];
    }
};

/// Material constants of a part.
MaterialConstants<double> materialConstants(const Part& part);
/// Whether a part asks for something that only GeneralPlasticity does.
bool needsGeneralPlasticity(const Part& part);

} // namespace fpm
