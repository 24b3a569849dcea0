#include "run/RunInputs.h"

#include "base/Format.h"
#include "dictionary/Number.h"
#include "io/Frames.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace fpm {

namespace {

constexpr std::array dictionaries{"constant/caseProperties", "constant/partProperties",
                                  "constant/boundaryConditions", "0/initialConditions",
                                  "system/contactDict"};

/// First words of the entries that may differ from one part of a run to the next.
constexpr std::array free{"title",           "application",   "startFrom",
                          "startTime",       "stopAt",        "endTime",
                          "writeControl",    "writeInterval", "purgeWrite",
                          "historyInterval", "functions",     "runTimeModifiable",
                          "maxWallTime",     "checkpoint",    "backend",
                          "threads",         "device",        "simd",
                          "precision",       "previousRun",   "writeFormat",
                          "writePrecision",  "timeFormat",    "writeCompression",
                          "timePrecision",   "energyBalance", "quasiStatic"};

/// The lines of Dictionary::canonicalText, each entry with the path to it.
std::string flattened(const std::string& canonical)
{
    std::string out;
    std::vector<std::string> path;
    std::istringstream lines(canonical);
    for (std::string line; std::getline(lines, line);) {
        const bool opens = line.ends_with(" {");
        if (line.starts_with('}') && !path.empty()) path.pop_back();
        if (opens) line.resize(line.size() - 2);
        if (line.ends_with(';')) line.pop_back();
        if (opens) path.push_back(line);
        if (opens || line.starts_with('}') || line.empty()) continue;
        const std::string& first = path.empty() ? line : path.front();
        const std::string word = first.substr(0, first.find(' '));
        if (std::ranges::find(free, word) != free.end()) continue;
        for (const std::string& part : path) out += part + ".";
        out += line + "\n";
    }
    return out;
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) out.push_back(line);
    return out;
}

/// "1e-3" and "0.001" say the same.
bool saySame(const std::string& a, const std::string& b)
{
    std::istringstream left(a), right(b);
    std::string one, other;
    while (left >> one) {
        if (!(right >> other)) return false;
        const auto x = readNumber(one), y = readNumber(other);
        if (x && y ? *x != *y : one != other) return false;
    }
    return !(right >> other);
}

std::string valueOf(const std::string& line)
{
    const auto blank = line.find(' ');
    return blank == line.npos ? "(no value)" : line.substr(blank + 1);
}

std::string nameOf(const std::string& line)
{
    return line.substr(0, line.find(' '));
}

/// Of two texts of one file; empty where they say the same.
std::string difference(const std::string& file, const std::string& now, const std::string& then)
{
    const std::vector<std::string> a = linesOf(now), b = linesOf(then);
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        if (i >= b.size()) return format("{}, {}: not in the checkpoint", file, nameOf(a[i]));
        if (i >= a.size()) return format("{}, {}: only in the checkpoint", file, nameOf(b[i]));
        if (saySame(a[i], b[i])) continue;
        if (nameOf(a[i]) == nameOf(b[i]))
            return format("{}, {}: {} now, {} in the checkpoint", file, nameOf(a[i]), valueOf(a[i]),
                          valueOf(b[i]));
        return format("{}: '{}' now, '{}' in the checkpoint", file, a[i], b[i]);
    }
    return "";
}

const std::string& textOf(const std::vector<RunInputs::File>& files, const std::string& name)
{
    static const std::string none;
    const auto found = std::ranges::find(files, name, &RunInputs::File::name);
    return found == files.end() ? none : found->text;
}

std::string wordOf(Precision precision)
{
    return precision == Precision::double_ ? "double"
           : precision == Precision::mixed ? "mixed"
                                           : "single";
}

} // namespace

std::string RunInputs::differenceFrom(const RunInputs& stored) const
{
    if (mesh != stored.mesh)
        return format("constant/mesh.vtkhdf: checksum {} now, {} in the checkpoint", mesh,
                      stored.mesh);
    for (const File& file : files)
        if (const std::string found =
                difference(file.name, file.text, textOf(stored.files, file.name));
            !found.empty())
            return found;
    return "";
}

RunInputs inputsOf(const Case& theCase, const Dictionary& control, const Control& effective)
{
    RunInputs out;
    // Empty texts too: a file may have come since, or gone.
    for (const char* file : dictionaries)
        out.files.push_back({file, theCase.hasFile(file)
                                       ? flattened(theCase.dictionary(file).canonicalText())
                                       : ""});
    out.files.push_back({"system/controlDict", flattened(control.canonicalText()) + "precision "
                                                   + wordOf(effective.precision) + "\n"});
    out.mesh = meshChecksumOf(theCase.root());
    return out;
}

} // namespace fpm
