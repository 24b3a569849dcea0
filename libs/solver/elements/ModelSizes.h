#pragma once

#include "model/Model.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace fpm {

/// Most entries of a list whose places are numbered by Index.
inline constexpr std::size_t mostPlaces = std::numeric_limits<Index>::max();

/// What the longest lists of a model are made from, counted before any of them is: lists are
/// addressed by Index, and a place beyond mostPlaces would come out as another one, without a word.
struct ModelSizes {
    struct Pass {
        std::string pair;
        std::size_t contactors; ///< with repetition, where one may touch several bodies
        std::size_t ownFaces, faces;
    };
    std::size_t paddedElements = 0; ///< of patches filled up to whole tiles
    std::size_t parts = 0;
    std::size_t pressureSides = 0;
    std::size_t uses = 0; ///< of conditions by nodes and their components
    std::size_t contactNodes = 0;
    std::vector<Pass> passes{};
};

ModelSizes sizesOf(const Model& model);
/// Throws Error(mesh) that names the first list that is too long, its limit and what would help.
void requirePlaces(const ModelSizes& sizes);
/// The same of the faces that the contactors of a pair leave out, known only as they are listed.
void requireExclusionPlaces(const std::string& pair, std::size_t exclusions);

} // namespace fpm
