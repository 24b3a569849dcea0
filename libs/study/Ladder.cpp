#include "study/Ladder.h"

#include "base/Format.h"
#include "dictionary/EntryEdit.h"
#include "dictionary/Number.h"
#include "dictionary/Suggestion.h"
#include "study/Overlay.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace fpm {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const Words& dictionaries()
{
    static const Words all{"system/meshDict",
                           "system/contactDict",
                           "system/controlDict",
                           "system/probeDict",
                           "constant/caseProperties",
                           "constant/partProperties",
                           "constant/boundaryConditions",
                           "0/initialConditions"};
    return all;
}

Words split(const std::string& path)
{
    std::istringstream stream(path);
    Words words;
    for (std::string word; std::getline(stream, word, '.');) words.push_back(word);
    return words;
}

/// "system/meshDict" of meshDict or system/meshDict.
std::string dictionaryOf(const Dictionary& ladder, const char* key, const std::string& given)
{
    Words names;
    for (const auto& file : dictionaries()) {
        const auto name = fs::path(file).filename().string();
        if (given == file || given == name) return file;
        names.push_back(given.find('/') == given.npos ? name : file);
    }
    ladder.fail(key, format("there is no dictionary '{}'", given), suggestion(given, names));
}

/// The items of a list: two of "(viscous 0.1)".
Words itemsOf(const std::string& list)
{
    return Dictionary::parse("row " + list + ";", "values").items("row");
}

/// The one value of 'value', which may be a list.
std::string valueOf(const Dictionary& entry)
{
    std::string text;
    for (const auto& item : entry.items("value")) text += (text.empty() ? "" : " ") + item;
    return entry.isList("value") ? "(" + text + ")" : text;
}

/// Keys that the annotated dictionary has below the dictionaries of `path` that exist in the case.
/// Their names are the user's own (parts, pairs), so only depth and the first word must fit.
bool isInManual(const Words& path, std::size_t existing, const std::string& file, Words& candidates)
{
    const auto manual = etcFolder() / "caseDicts" / fs::path(file).filename();
    for (const auto& text : Dictionary::read(manual, manual.parent_path()).keyPaths()) {
        const Words other = split(text);
        if (other.size() <= existing) continue;
        if (existing > 1 && other[0] != path[0]) continue;
        candidates.push_back(other[existing]);
        if (other.size() == path.size()
            && std::equal(path.begin() + std::ptrdiff_t(existing), path.end(),
                          other.begin() + std::ptrdiff_t(existing)))
            return true;
    }
    return false;
}

/// The files of this name, of the case and of the folders laid over it.
std::vector<fs::path>
filesOf(const std::string& file, const Case& theCase, const std::vector<CaseChange>& overlays)
{
    std::vector<fs::path> files;
    if (theCase.hasFile(file)) files.push_back(theCase.path(file));
    for (const auto& one : overlays)
        if (!one.overlay.empty() && fs::exists(theCase.inside(one.overlay) / file))
            files.push_back(theCase.inside(one.overlay) / file);
    return files;
}

void requireKnown(const Dictionary& entry,
                  const char* key,
                  const CaseChange& change,
                  const Case& theCase,
                  const std::vector<CaseChange>& overlays)
{
    const auto files = filesOf(change.file, theCase, overlays);
    if (files.empty()) entry.fail(key, format("the case has no {}", change.file));
    // What is laid over last is what a run has.
    const auto existing = existingPath(files.back(), theCase.root(), change.path);
    if (existing == change.path) return;
    const Words path = split(change.path);
    const std::size_t depth = split(existing).size();
    Words candidates;
    if (isInManual(path, depth, change.file, candidates)) return;

    auto place = Dictionary::read(files.back(), theCase.root());
    for (std::size_t i = 0; i < depth && place.isDictionary(path[i]); ++i)
        place = place.sub(path[i]);
    for (const auto& other : place.keys()) candidates.push_back(other);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    entry.fail(key,
               format("{} has no entry '{}'{}", change.file, path[depth],
                      existing.empty() ? "" : " in " + existing),
               suggestion(path[depth], candidates));
}

/// File and keywords of "controlDict.timeStep.safety".
CaseChange readEntry(const Dictionary& entry,
                     const char* key,
                     const std::string& given,
                     const Case& theCase,
                     const std::vector<CaseChange>& overlays)
{
    const auto slash = given.rfind('/');
    const auto dot = given.find('.', slash == given.npos ? 0 : slash);
    if (dot == given.npos || dot + 1 == given.size() || dot == 0)
        entry.fail(key, format("'{}' names no entry", given),
                   "write file and keywords: controlDict.timeStep.safety");
    const CaseChange change{dictionaryOf(entry, key, given.substr(0, dot)), given.substr(dot + 1),
                            "", ""};
    requireKnown(entry, key, change, theCase, overlays);
    return change;
}

/// One entry, whose values are the rungs, or several, whose values are rows.
void readValues(const Dictionary& entry,
                Ladder& ladder,
                const Case& theCase,
                const std::vector<CaseChange>& fixed)
{
    const bool isOne = !entry.has("entries");
    const char* key = isOne ? "entry" : "entries";
    std::vector<CaseChange> places;
    for (const auto& given : isOne ? Words{entry.word("entry")} : entry.words("entries"))
        places.push_back(readEntry(entry, key, given, theCase, fixed));
    ladder.values = entry.items("values");
    for (const auto& text : ladder.values) {
        const Words row = isOne ? Words{text} : itemsOf(text);
        if (row.size() != places.size())
            entry.fail("values", format("'{}' is no row of {} values", text, places.size()),
                       "every value is a list, one item for each of 'entries'");
        auto changes = places;
        for (std::size_t i = 0; i < row.size(); ++i) changes[i].value = row[i];
        ladder.changes.push_back(std::move(changes));
    }
}

void readOverlays(const Dictionary& entry, Ladder& ladder, const Case& theCase)
{
    ladder.values = entry.words("overlay");
    for (const auto& folder : ladder.values) {
        ladder.changes.emplace_back();
        if (folder == "none") continue;
        requireOverlay(entry, folder, theCase);
        ladder.changes.back().push_back({"", "", "", folder});
    }
}

bool endsAsRefinement(const Ladder& ladder)
{
    return ladder.changes.size() > 0 && ladder.changes[0].size() == 1
           && ladder.changes[0][0].path.ends_with("refinement");
}

/// Steps as they are given, or from the values.
void readSteps(const Dictionary& entry, Ladder& ladder)
{
    if (entry.has("steps")) {
        ladder.steps = entry.numbers("steps");
        for (const double step : ladder.steps)
            if (!(step > 0)) entry.fail("steps", "steps are > 0");
        if (ladder.steps.size() != ladder.values.size())
            entry.fail("steps",
                       format("{} steps for {} values", ladder.steps.size(), ladder.values.size()));
    }
    const auto order = entry.choiceOr("order", endsAsRefinement(ladder) ? "inverse" : "none",
                                      {"none", "value", "inverse"});
    if (order == "none" || !ladder.steps.empty()) return;
    for (const auto& value : ladder.values) {
        const auto number = readNumber(value);
        if (!number || !(*number > 0))
            entry.fail("values", "an order of convergence needs values > 0",
                       "write positive numbers, steps (...), or order none;");
        ladder.steps.push_back(order == "value" ? *number : 1 / *number);
    }
}

/// Entries whose smaller value is the finer one.
bool isFinerDownward(const Ladder& ladder)
{
    static const Words endings{"safety",         "contactLimit",
                               "searchInterval", "massScaling.factor",
                               "timeStep.fixed", "timeStep.maximum"};
    if (ladder.changes.front().empty()) return false;
    const std::string& path = ladder.changes.front().front().path;
    return std::any_of(endings.begin(), endings.end(),
                       [&](const std::string& ending) { return path.ends_with(ending); });
}

/// A number, or of a row of numbers their sum: rows of cells, say, of which one grows.
std::optional<double> sizeOf(const std::string& value)
{
    double sum = 0;
    for (const auto& item : value.starts_with('(') ? itemsOf(value) : Words{value}) {
        const auto number = readNumber(item);
        if (!number) return {};
        sum += *number;
    }
    return sum;
}

/// Which values are finer: by their steps, else as numbers ascend. Words have no such order.
void rankValues(Ladder& ladder)
{
    ladder.coarseness = ladder.steps;
    if (!ladder.steps.empty()) return;
    const double sign = isFinerDownward(ladder) ? 1 : -1;
    for (const auto& value : ladder.values) {
        const auto size = sizeOf(value);
        if (!size) return ladder.coarseness.clear();
        ladder.coarseness.push_back(sign * *size);
    }
}

void readNames(const Dictionary& entry, Ladder& ladder, const std::string& key)
{
    const auto requireDistinct = [&](const std::string& where) {
        const std::set<std::string> distinct(ladder.values.begin(), ladder.values.end());
        if (distinct.size() != ladder.values.size())
            entry.fail(where, "a value stands here twice", "delete one; 'repeats' runs all again");
    };
    requireDistinct(key);
    if (!entry.has("names")) return;
    const auto count = ladder.values.size();
    ladder.values = entry.items("names"); // numbers too
    for (auto& name : ladder.values) std::erase(name, '"');
    if (ladder.values.size() != count)
        entry.fail("names", format("{} names for {} values", ladder.values.size(), count));
    requireDistinct("names");
}

/// A value as part of a file name.
std::string fileWord(const std::string& value)
{
    std::string word;
    for (const char c : value) {
        const bool isSafe =
            std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+';
        if (isSafe)
            word += c;
        else if (!word.empty() && word.back() != '-')
            word += '-';
    }
    while (word.ends_with('-')) word.pop_back();
    return word.substr(0, 40);
}

Rung rungOf(const std::vector<Ladder>& ladders, std::vector<int> values)
{
    Rung rung;
    for (std::size_t i = 0; i < ladders.size(); ++i) {
        if (values[i] < 0) continue;
        const auto& ladder = ladders[i];
        const auto& value = ladder.values[std::size_t(values[i])];
        rung.run.name += format("{}{}_{}", rung.run.name.empty() ? "" : ".", fileWord(ladder.name),
                                fileWord(value));
        rung.label += format("{}{} {}", rung.label.empty() ? "" : ", ", ladder.name, value);
        const auto& changes = ladder.changes[std::size_t(values[i])];
        rung.run.changes.insert(rung.run.changes.end(), changes.begin(), changes.end());
    }
    rung.values = std::move(values);
    return rung;
}

/// Values that differ in signs alone would share a folder.
void makeNamesUnique(std::vector<Rung>& rungs)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        auto& name = rungs[i].run.name;
        if (name.size() > 150) name = name.substr(0, 150);
        if (!names.insert(name).second) names.insert(name += format("-{}", i));
    }
}

} // namespace

std::vector<CaseChange> readFixed(const Dictionary& entries, const Case& theCase)
{
    // Folders first: they may bring the entries.
    std::vector<CaseChange> fixed;
    for (const auto& name : entries.keys())
        if (const auto entry = entries.sub(name); entry.has("overlay")) {
            fixed.push_back({"", "", "", entry.word("overlay")});
            requireOverlay(entry, fixed.back().overlay, theCase);
        }
    for (const auto& name : entries.keys()) {
        const auto entry = entries.sub(name);
        if (entry.has("overlay")) continue;
        auto change = readEntry(entry, "entry", entry.word("entry"), theCase, fixed);
        change.value = valueOf(entry);
        fixed.push_back(std::move(change));
    }
    return fixed;
}

std::vector<Ladder>
readLadders(const Dictionary& entries, const Case& theCase, const std::vector<CaseChange>& fixed)
{
    std::vector<Ladder> ladders;
    for (const auto& name : entries.keys()) {
        const auto entry = entries.sub(name);
        Ladder ladder;
        ladder.name = name;
        const bool isOverlay = entry.has("overlay");
        if (isOverlay)
            readOverlays(entry, ladder, theCase);
        else
            readValues(entry, ladder, theCase, fixed);
        const std::string key = isOverlay ? "overlay" : "values";
        if (ladder.values.empty()) entry.fail(key, "a ladder needs at least one value");
        readSteps(entry, ladder);
        readNames(entry, ladder, key);
        rankValues(ladder);
        ladders.push_back(std::move(ladder));
    }
    return ladders;
}

Plan productOf(const std::vector<Ladder>& ladders)
{
    Plan plan;
    std::vector<int> values(ladders.size(), 0);
    for (bool more = true; more;) {
        // The first ladder turns fastest: one line after the other.
        if (values[0] == 0) {
            auto others = values;
            others[0] = -1;
            const auto label = rungOf(ladders, others).label;
            plan.lines.push_back({label.empty() ? ladders[0].name : label, 0, {}});
        }
        plan.lines.back().rungs.push_back(plan.rungs.size());
        plan.rungs.push_back(rungOf(ladders, values));
        more = false;
        for (std::size_t i = 0; i < ladders.size() && !more; ++i) {
            more = ++values[i] < int(ladders[i].values.size());
            if (!more) values[i] = 0;
        }
    }
    makeNamesUnique(plan.rungs);
    return plan;
}

Plan eachOf(const std::vector<Ladder>& ladders)
{
    Plan plan;
    for (std::size_t i = 0; i < ladders.size(); ++i) {
        plan.lines.push_back({ladders[i].name, i, {}});
        for (std::size_t value = 0; value < ladders[i].values.size(); ++value) {
            std::vector<int> values(ladders.size(), -1);
            values[i] = int(value);
            plan.lines.back().rungs.push_back(plan.rungs.size());
            plan.rungs.push_back(rungOf(ladders, values));
        }
    }
    makeNamesUnique(plan.rungs);
    return plan;
}

} // namespace fpm
