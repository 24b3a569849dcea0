#include "study/Ladder.h"

#include "base/Format.h"
#include "dictionary/EntryEdit.h"
#include "dictionary/Number.h"
#include "dictionary/Suggestion.h"

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
std::string dictionaryOf(const Dictionary& ladder, const std::string& given)
{
    Words names;
    for (const auto& file : dictionaries()) {
        const auto name = fs::path(file).filename().string();
        if (given == file || given == name) return file;
        names.push_back(given.find('/') == given.npos ? name : file);
    }
    ladder.fail("entry", format("there is no dictionary '{}'", given), suggestion(given, names));
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

void requireKnown(const Dictionary& entry, const Ladder& ladder, const Case& theCase)
{
    if (!theCase.hasFile(ladder.file))
        entry.fail("entry", format("the case has no {}", ladder.file));
    const auto existing = existingPath(theCase.path(ladder.file), theCase.root(), ladder.path);
    if (existing == ladder.path) return;
    const Words path = split(ladder.path);
    const std::size_t depth = split(existing).size();
    Words candidates;
    if (isInManual(path, depth, ladder.file, candidates)) return;

    auto place = theCase.dictionary(ladder.file);
    for (std::size_t i = 0; i < depth && place.isDictionary(path[i]); ++i)
        place = place.sub(path[i]);
    for (const auto& key : place.keys()) candidates.push_back(key);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    entry.fail("entry",
               format("{} knows no '{}'{}", ladder.file, path[depth],
                      existing.empty() ? "" : " in " + existing),
               suggestion(path[depth], candidates));
}

void readEntry(const Dictionary& entry, Ladder& ladder, const Case& theCase)
{
    const auto given = entry.word("entry");
    const auto slash = given.rfind('/');
    const auto dot = given.find('.', slash == given.npos ? 0 : slash);
    if (dot == given.npos || dot + 1 == given.size() || dot == 0)
        entry.fail("entry", format("'{}' names no entry", given),
                   "write file and keywords: controlDict.timeStep.safety");
    ladder.file = dictionaryOf(entry, given.substr(0, dot));
    ladder.path = given.substr(dot + 1);
    ladder.values = entry.items("values");
    const bool isRefinement = ladder.path.substr(ladder.path.rfind('.') + 1) == "refinement";
    const auto step =
        entry.choiceOr("order", isRefinement ? "inverse" : "none", {"none", "value", "inverse"});
    ladder.step = step == "none" ? StepOf::none : step == "value" ? StepOf::value : StepOf::inverse;
    requireKnown(entry, ladder, theCase);
    for (std::size_t i = 0; ladder.step != StepOf::none && i < ladder.values.size(); ++i)
        if (!(ladder.stepAt(i) > 0))
            entry.fail("values", "an order of convergence needs values > 0",
                       "write positive numbers, or order none;");
}

void readOverlays(const Dictionary& entry, Ladder& ladder, const Case& theCase)
{
    ladder.values = entry.words("overlay");
    for (const auto& folder : ladder.values)
        if (folder != "none" && !fs::is_directory(theCase.inside(folder)))
            entry.fail("overlay", format("the case has no folder '{}'", folder),
                       "none is the case as it is");
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
        if (!ladder.isOverlay())
            rung.run.changes.push_back({ladder.file, ladder.path, value, ""});
        else if (value != "none")
            rung.run.changes.push_back({"", "", "", value});
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

double Ladder::stepAt(std::size_t value) const
{
    const auto number = readNumber(values[value]);
    if (step == StepOf::none || !number || !(*number > 0)) return 0;
    return step == StepOf::value ? *number : 1 / *number;
}

std::vector<Ladder> readLadders(const Dictionary& entries, const Case& theCase)
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
            readEntry(entry, ladder, theCase);
        const std::string key = isOverlay ? "overlay" : "values";
        if (ladder.values.empty()) entry.fail(key, "a ladder needs at least one value");
        const std::set<std::string> distinct(ladder.values.begin(), ladder.values.end());
        if (distinct.size() != ladder.values.size())
            entry.fail(key, "a value stands here twice", "delete one; 'repeats' runs all again");
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
