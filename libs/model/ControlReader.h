#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// system/controlDict without `functions`. Keys of OpenFOAM without effect here are accepted and
/// named in the log; values that would mean something else are refused.
Control readControl(const Dictionary& dictionary, Log& log);

/// Takes over what may change while a run goes on: endTime, stopAt, maxWallTime, the intervals of
/// frames, rows and checkpoints. All of it or, where one is wrong (InputError), nothing.
void rereadControl(const Dictionary& dictionary, Control& control);

/// system/controlDict, massScaling: into the parts it is for.
void readMassScaling(const Dictionary& dictionary, std::vector<Part>& parts);

/// system/controlDict, functions { ... }: a point's node and a reaction's nodes are resolved
/// against the mesh, parts, conditions and surfaces of `model`.
std::vector<History> readHistories(const Dictionary& dictionary, const Model& model, Log& log);

} // namespace fpm
