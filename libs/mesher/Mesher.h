#pragma once

#include "base/Log.h"
#include "case/Case.h"
#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"

namespace fpm {

/// The work of fpmMesh: meshes every body of `meshDict`, makes its sets, checks and renumbers, and
/// reports elements, nodes and quality of each body to `log`. Bodies share no nodes; those of boxes
/// and cylinders lie exactly on their planes and arcs. zeta of an element runs along z in boxes and
/// layers, along the axis in cylinders and outward in hollow cylinders; imported ones stay as they
/// are. Files are looked for inside `theCase`; a .geo runs only where `allowGeo`.
/// Throws InputError (wrong or unknown entries, sets that come out empty), Error(mesh) (files,
/// geometry that gives bad elements), Error(memory) (more elements than this machine can hold).
Mesh makeMesh(const Dictionary& meshDict, const Case& theCase, bool allowGeo, Log& log);

} // namespace fpm
