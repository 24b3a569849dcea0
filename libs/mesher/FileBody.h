#pragma once

#include "base/Log.h"
#include "mesh/Mesh.h"
#include "mesher/ImportedMesh.h"

#include <string>

namespace fpm {

/// A body from a file as parts and sets: physical volumes become parts (without any: one part
/// called `body`), physical surfaces side sets, physical curves and points node sets. A group
/// without name is <body>.volume3, .surface3, ... after its tag. Of a face between two elements the
/// set has the side with the outward direction of the file's quadrangle. Throws Error(mesh): a
/// hexahedron in no or two volumes, a face of no hexahedron, an unusable name.
Mesh fileBody(const std::string& body, const std::string& file, const ImportedMesh& imported);

/// A name of a part or set: 1 to 64 of A-Z a-z 0-9 _ . + -, no leading dot.
bool isName(const std::string& text);
/// The rule above in words, for messages.
inline constexpr const char* nameRule = "1 to 64 of A-Z a-z 0-9 _ . + -, not starting with a dot";

} // namespace fpm
