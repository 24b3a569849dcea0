#pragma once

#include "case/Case.h"
#include "mesh/Mesh.h"

namespace fpm {

/// The work of fpmSetContact: resolves system/contactDict (or `dict`) against the mesh, reports
/// counts, areas, initial gaps and overlaps, and returns the mesh with `contact` filled in.
/// Refuses empty surfaces, rigid-rigid pairs, a node that is its own target, unknown names.
void setContact(Mesh& mesh, const Dictionary& contactDict, const Case& theCase, Log& log);
/// The same where it is known which parts are rigid, without a case.
void setContact(Mesh& mesh,
                const Dictionary& contactDict,
                const std::vector<bool>& rigid,
                Log& log);

/// True when the case has a contactDict and the mesh file's surfaces were not made from it.
bool contactIsOutdated(const Mesh& mesh, const Case& theCase);

/// Does the work of fpmSetContact, and says so, where contactIsOutdated; rewrites the mesh file.
void updateContact(const Case& theCase, Log& log);

} // namespace fpm
