#pragma once

#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"

#include <vector>

namespace fpm {

/// Contactor nodes that lie in the material of the target before the run, by what contact does with
/// them. It holds a node against a face that points towards it, no deeper than half the thickness
/// of the element under the face (kernels/contact/narrow/FaceChoice.h): beyond, the other side may
/// be nearer.
struct InitialDepths {
    struct Node {
        Index node;
        double depth;  ///< under the face through which it entered
        Point surface; ///< the place on that face nearest to it
        double limit;  ///< half the thickness under it
    };
    std::vector<Node> held;    ///< they are pushed out
    std::vector<Node> tooDeep; ///< they would feel no force
    std::vector<Index> astray; ///< as these, but no face of the target leads out
    bool none() const { return held.empty() && tooDeep.empty() && astray.empty(); }
};
InitialDepths initialDepths(const Mesh& mesh, const ContactSurfaces& surfaces);

/// Throws InputError at `key` of `place` where nodes are too deep; with two passes nodes of either
/// side count.
void refuseDeepStart(const Mesh& mesh,
                     const ContactSurfaces& surfaces,
                     int passes,
                     const Dictionary& place,
                     const std::string& key = "target");

/// Mean of the unit normals of a node's own sides, per contactor node; short where they cancel.
std::vector<Point> contactorNormals(const Mesh& mesh, const ContactSurfaces& surfaces);

} // namespace fpm
