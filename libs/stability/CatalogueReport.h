#pragma once

#include "base/Log.h"
#include "stability/Catalogue.h"

namespace fpm {

/// One entry with its results, by ContactVariant.
struct CatalogueRow {
    const Failure* failure = nullptr;
    std::array<Verdict, 3> verdicts;
    bool isExpected() const;
};

/// Entries named by scene or number, with commas ("F1,largeFace"); all when `names` is empty.
/// Throws Error(commandLine) for others.
std::vector<const Failure*> chosenFailures(const std::string& names);

/// The rows as doc/failures.md.
std::string failureDocument(const std::vector<CatalogueRow>& rows);

/// fpmStability -catalogue: runs the scenes on `threads` threads and prints a line each; with a
/// folder writes failures.md, failures.svg and failures.dat into it. Throws Error(numericalStop)
/// where an outcome is not the expected one.
void runCatalogue(const std::string& names, const std::string& folder, int threads, Log& log);

} // namespace fpm
