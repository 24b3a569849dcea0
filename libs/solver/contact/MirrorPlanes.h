#pragma once

#include "model/Model.h"

namespace fpm {

/// A symmetry plane of the scene, however many conditions define it.
struct MirrorPlane {
    Point normal;            ///< unit
    double distance;         ///< of the undeformed plane from the origin, along the normal
    std::vector<bool> holds; ///< [node]
};

/// Throws Error where there are more than 8, the bits that contactors have for them.
std::vector<MirrorPlane> mirrorPlanes(const Model& model);

} // namespace fpm
