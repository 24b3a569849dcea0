#include "advise/CaseEdits.h"

#include "dictionary/EntryEdit.h"
#include "io/AtomicFile.h"

#include <fstream>
#include <sstream>

namespace fpm {

void CaseEdits::set(const std::string& file, const std::string& path, const std::string& value)
{
    changes.push_back({file, path, value, ""});
}

void CaseEdits::remove(const std::string& file, const std::string& path, const std::string& note)
{
    removals.push_back({file, path, note});
}

void CaseEdits::add(const CaseEdits& others)
{
    changes.insert(changes.end(), others.changes.begin(), others.changes.end());
    removals.insert(removals.end(), others.removals.begin(), others.removals.end());
    for (const auto& [file, text] : others.additions) additions[file] += text;
    notes.insert(notes.end(), others.notes.begin(), others.notes.end());
}

void CaseEdits::make(const Case& theCase, const std::filesystem::path& copy) const
{
    const auto root = std::filesystem::canonical(copy);
    for (const CaseChange& one : changes) change(theCase, copy, one);
    for (const Removal& one : removals) {
        const EntryEdit edit = removeEntry(copy / one.file, root, one.path, one.note);
        writeFileAtomically(copy / edit.file, edit.text);
    }
    for (const auto& [file, text] : additions) {
        std::ostringstream whole;
        if (std::ifstream stream(copy / file); stream) whole << stream.rdbuf();
        whole << text;
        writeFileAtomically(copy / file, whole.str());
    }
}

} // namespace fpm
