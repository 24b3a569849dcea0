#pragma once

#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// constant/partProperties: the properties of every part, in the order of mesh.parts. Throws
/// InputError for a part without entry, an entry without part, and values outside their range.
std::vector<Part> readParts(const Dictionary& dictionary, const Mesh& mesh);

/// Which parts of the mesh are rigid; nothing else of constant/partProperties is read, so that
/// contact can be set up before the materials are complete.
std::vector<bool> readRigidParts(const Dictionary& dictionary, const Mesh& mesh);

} // namespace fpm
