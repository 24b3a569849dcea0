#pragma once

#include "study/CaseCopy.h"

#include <map>
#include <string>
#include <vector>

namespace fpm {

/// Changes of the dictionaries of a copy of a case, and notes for its user.
struct CaseEdits {
    struct Removal {
        std::string file, path, note;
    };
    std::vector<CaseChange> changes;
    std::vector<CaseChange> kept; ///< what an entry would lose by the changes; these come first
    std::vector<Removal> removals;
    std::map<std::string, std::string> additions; ///< text behind a file, by file
    std::vector<std::string> notes;               ///< sentences for the copy's README

    void set(const std::string& file, const std::string& path, const std::string& value);
    /// The value an entry has, where it is taken from one that changes.
    void keep(const std::string& file, const std::string& path, const std::string& value);
    void remove(const std::string& file, const std::string& path, const std::string& note);
    void add(const CaseEdits& others);
    bool empty() const { return changes.empty() && removals.empty() && additions.empty(); }
    /// Throws InputError where one cannot be made.
    void make(const Case& theCase, const OutputFolder& copy) const;
};

} // namespace fpm
