#include "advise/CaseEdits.h"

#include "base/Format.h"
#include "dictionary/Dictionary.h"
#include "dictionary/EntryEdit.h"

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace fpm {

namespace {

std::string textOf(const std::filesystem::path& file)
{
    std::ostringstream whole;
    if (std::ifstream stream(file); stream) whole << stream.rdbuf();
    return whole.str();
}

/// Names of the values that a text uses as $name.
std::set<std::string> macrosOf(const std::string& text)
{
    static const std::regex macro("\\$:?([A-Za-z_][A-Za-z0-9_]*)");
    std::set<std::string> names;
    for (std::sregex_iterator it(text.begin(), text.end(), macro), end; it != end; ++it)
        names.insert((*it)[1]);
    return names;
}

/// An unused value at the top level would be an unknown keyword. In controlDict, whose values at
/// the top level are read as entries, nothing is removed.
void removeOrphans(const OutputFolder& copy,
                   const std::string& file,
                   const std::set<std::string>& before)
{
    const auto root = std::filesystem::canonical(copy.path());
    if (file == "system/controlDict" || !std::filesystem::exists(root / file)) return;
    const std::set<std::string> now = macrosOf(textOf(root / file));
    for (const std::string& name : before) {
        const Dictionary dictionary = Dictionary::read(root / file, root);
        if (now.count(name) > 0 || !dictionary.has(name) || dictionary.isDictionary(name)) continue;
        const EntryEdit edit =
            removeEntry(root / file, root, name, format("{}: nothing uses it any more", name));
        copy.write(edit.file.string(), edit.text);
    }
}

} // namespace

void CaseEdits::set(const std::string& file, const std::string& path, const std::string& value)
{
    changes.push_back({file, path, value, ""});
}

void CaseEdits::keep(const std::string& file, const std::string& path, const std::string& value)
{
    kept.push_back({file, path, value, ""});
}

void CaseEdits::remove(const std::string& file, const std::string& path, const std::string& note)
{
    removals.push_back({file, path, note});
}

void CaseEdits::add(const CaseEdits& others)
{
    changes.insert(changes.end(), others.changes.begin(), others.changes.end());
    kept.insert(kept.end(), others.kept.begin(), others.kept.end());
    removals.insert(removals.end(), others.removals.begin(), others.removals.end());
    for (const auto& [file, text] : others.additions) additions[file] += text;
    notes.insert(notes.end(), others.notes.begin(), others.notes.end());
}

void CaseEdits::make(const Case& theCase, const OutputFolder& copy) const
{
    const auto root = std::filesystem::canonical(copy.path());
    std::map<std::string, std::set<std::string>> macros;
    for (const CaseChange& one : changes) macros[one.file] = macrosOf(textOf(root / one.file));
    for (const Removal& one : removals) macros[one.file] = macrosOf(textOf(root / one.file));
    for (const CaseChange& one : kept) change(theCase, copy, one);
    for (const CaseChange& one : changes) change(theCase, copy, one);
    for (const Removal& one : removals) {
        const EntryEdit edit = removeEntry(root / one.file, root, one.path, one.note);
        copy.write(edit.file.string(), edit.text);
    }
    for (const auto& [file, names] : macros) removeOrphans(copy, file, names);
    for (const auto& [file, text] : additions) copy.write(file, textOf(root / file) + text);
}

} // namespace fpm
