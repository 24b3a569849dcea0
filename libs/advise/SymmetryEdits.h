#pragma once

#include "advise/CaseEdits.h"
#include "advise/CutMesh.h"
#include "model/Model.h"

namespace fpm {

/// Sides to keep: those where points of histories lie, else the upper ones.
Cut chooseCut(const Model& model, const std::vector<MirrorPlane>& planes);

/// What the dictionaries of a cut case need: conditions on the planes, loads of halved nodes,
/// contact surfaces without the sides of the cut, histories and probes on the side that is kept.
/// Adds the sets they name to `mesh`, which is still whole.
CaseEdits symmetryEdits(const Model& model, const Case& theCase, const Cut& cut, Mesh& mesh);

} // namespace fpm
