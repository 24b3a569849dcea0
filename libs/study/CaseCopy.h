#pragma once

#include "case/Case.h"

#include <filesystem>
#include <string>

namespace fpm {

/// What one copy of a case has that the case has not: an entry with another value, or the files of
/// a folder laid over those of the case.
struct CaseChange {
    std::string file, path, value; ///< "system/controlDict", "timeStep.safety", "0.5"
    std::string overlay;           ///< relative to the case; the entry counts where empty
};

/// Copies what a person wrote, not what programs made: no results, logs, hidden files; the mesh
/// only where no meshDict makes it. Links are followed inside the case; links to folders are
/// refused.
void copyCase(const Case& theCase, const std::filesystem::path& copy);

/// Makes the change in a copy of the case. Throws InputError where the entry cannot be set.
void change(const Case& theCase, const std::filesystem::path& copy, const CaseChange& change);

/// Checksum of what a run of this case depends on: its dictionaries with all they include, comments
/// and layout aside, and its mesh files. probeDict counts `withProbes` only.
std::string caseKey(const std::filesystem::path& root, bool withProbes);

/// Removes frames and mesh, leaves dictionaries, logs and histories.
void removeFields(const std::filesystem::path& root);

/// Whether fpmProbe or the solver made a folder or file of this name at the top of a case.
bool isResult(const std::string& name);

} // namespace fpm
