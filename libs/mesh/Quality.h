#pragma once

#include "base/Log.h"
#include "mesh/Mesh.h"

namespace fpm {

/// Volume of a hexahedron with bilinear faces (exact mean quadrature, method of Flanagan and
/// Belytschko 1981) in the case's length unit cubed.
double volume(const Mesh& mesh, Index element);

/// Shape of all elements. Scaled Jacobian: least of the corners, 1 for a brick, <= 0 inside out;
/// edge ratio: longest by shortest edge of an element; height: volume by largest side, a length.
/// `worstElement` has the least scaled Jacobian (-1: no elements).
struct Quality {
    double minScaledJacobian, medianScaledJacobian, maxEdgeRatio, minHeight, totalVolume;
    Index worstElement;
};
Quality quality(const Mesh& mesh);

/// Refuses (Error mesh, with the first 10 element ids) repeated nodes, node numbers out of range,
/// NaN or huge coordinates, volume or corner Jacobian <= 0 ("mirrored numbering" if all are);
/// warns on scaled Jacobian < 0.1, coincident nodes inside one part and orphan nodes. Numbers in
/// messages count from 0, as ParaView shows them.
/// `source` names the file or dictionary for messages.
void checkMesh(const Mesh& mesh, const std::string& source, Log& log);

} // namespace fpm
