#pragma once

#include "kernels/element/ElementKernels.h"
#include "model/Model.h"

namespace fpm {

/// Entry of a deformable part's law in the list of materials.
const MaterialEntry& materialOf(PartKind kind);
/// Kind with a material of the list.
template <class Material>
inline constexpr PartKind kindOf = PartKind(Materials::indexOf<Material>());
/// False for rigid parts too.
bool isPlastic(PartKind kind);

/// Words of `model` in a dictionary: materials in the order of the list, then the rigid kinds.
std::vector<std::string> kindWords();
std::string wordOf(PartKind kind);
/// Kind of one of kindWords().
PartKind kindNamed(const std::string& word);

/// Kernel of a deformable part; isKernel() is false where its law has none in its element.
ElementKernel kernelOf(const Part& part);
/// What the kernels of a law allow, as a sentence for a message.
std::string elementsOf(PartKind kind);

} // namespace fpm
