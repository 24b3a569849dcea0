#pragma once

#include "case/Case.h"
#include "io/OutputFolder.h"

#include <filesystem>
#include <string>

namespace fpm {

/// What one copy of a case has that the case has not: an entry with another value, or the files of
/// a folder laid over those of the case.
struct CaseChange {
    std::string file, path, value; ///< "system/controlDict", "timeStep.safety", "0.5"
    std::string overlay;           ///< relative to the case; the entry counts where empty
};

/// An empty folder for a copy of a case, with the mark by which removeCopy knows it. Throws
/// Error(fileIo) where there is a folder that has something in it.
OutputFolder makeCopyFolder(const OutputFolder& output, const std::string& folder);
/// Throws Error(fileIo) for a link, and for a folder that makeCopyFolder did not make: a person may
/// have put it there.
void requireCopy(const OutputFolder& output, const std::string& folder);
/// Removes a copy, or does nothing where there is none. Throws as requireCopy.
void removeCopy(const OutputFolder& output, const std::string& folder);
/// Lets a copy be a case as any other.
void keepCopy(const OutputFolder& copy);

/// Copies what a person wrote, not what programs made: no results, logs, hidden files; the mesh
/// only where no meshDict makes it. Links are followed inside the case; links to folders are
/// refused.
void copyCase(const Case& theCase, const OutputFolder& copy);

/// Makes the change in a copy of the case. Throws InputError where the entry cannot be set.
void change(const Case& theCase, const OutputFolder& copy, const CaseChange& change);

/// Checksums of what a run of this case depends on: its dictionaries with all they include,
/// comments and layout aside, and its mesh files.
struct CaseKeys {
    std::string whole;        ///< probeDict counts where fpmProbe runs too
    std::string butItsLength; ///< without endTime, title and probeDict
};
CaseKeys keysOf(const std::filesystem::path& root, bool withProbes);

/// Notes in its mark what a copy was made of, once it is complete; empty where a copy has no note.
void noteKey(const OutputFolder& copy, const std::string& key);
std::string notedKey(const std::filesystem::path& copy);

/// Copies the dictionaries and files of `from` over those of a copy, but no mesh that a run uses.
void renewInputs(const std::filesystem::path& from, const OutputFolder& copy);

/// Removes frames and mesh, leaves dictionaries, logs and histories.
void removeFields(const OutputFolder& copy);

/// Whether fpmProbe or the solver made a folder or file of this name at the top of a case.
bool isResult(const std::string& name);

} // namespace fpm
