#include "case/UnreadFiles.h"

#include "base/Format.h"
#include "dictionary/Suggestion.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <sstream>
#include <system_error>

namespace fpm {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 10> dictionaries{
    "system/controlDict",      "system/contactDict",      "system/meshDict",
    "system/probeDict",        "system/chartDict",        "system/stabilityDict",
    "constant/caseProperties", "constant/partProperties", "constant/boundaryConditions",
    "0/initialConditions"};
/// Read where they are there, and absent without a word.
constexpr std::array<const char*, 3> optionalFiles{"constant/boundaryConditions",
                                                   "0/initialConditions", "system/contactDict"};
constexpr std::size_t mostEdits = 3, mostBytes = 1 << 20;

bool isKnown(const std::string& relative)
{
    return std::find(dictionaries.begin(), dictionaries.end(), relative) != dictionaries.end();
}

std::string lower(std::string text)
{
    for (char& letter : text) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

/// A misspelling; the name with something before or behind it is a variant, kept on purpose.
bool resembles(const std::string& name, const std::string& wanted)
{
    const auto isPlain = [](unsigned char letter) { return std::isalnum(letter) || letter == '_'; };
    if (!std::all_of(name.begin(), name.end(), isPlain)) return false;
    if (name == wanted) return true;
    if (name.find(wanted) != std::string::npos || name.size() > wanted.size() + mostEdits)
        return false;
    const std::size_t edits = editDistance(lower(name), lower(wanted));
    return edits <= std::min(mostEdits, wanted.size() / 4);
}

std::string startOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text(mostBytes, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(std::max<std::streamsize>(0, stream.gcount())));
    return text;
}

/// Whether a dictionary of the case has the name in quotes, as #include has it.
bool isIncluded(const Case& theCase, const std::string& name)
{
    return std::any_of(dictionaries.begin(), dictionaries.end(), [&](const char* relative) {
        std::error_code failure;
        return fs::is_regular_file(theCase.path(relative), failure)
               && startOf(theCase.path(relative)).find(name + '"') != std::string::npos;
    });
}

} // namespace

std::string lookalikeOf(const Case& theCase, const std::string& relative)
{
    if (theCase.hasFile(relative)) return "";
    const std::string wanted = fs::path(relative).filename().string();
    std::vector<std::string> found;
    for (const char* folder : {"system", "constant", "0"}) {
        std::error_code failure;
        for (const auto& entry : fs::directory_iterator(theCase.path(folder), failure)) {
            const std::string name = entry.path().filename().string(),
                              candidate = std::string(folder) + "/" + name;
            if (entry.is_regular_file(failure) && !isKnown(candidate) && resembles(name, wanted)
                && !isIncluded(theCase, name))
                found.push_back(candidate);
        }
    }
    return found.empty() ? "" : *std::min_element(found.begin(), found.end());
}

void warnOfUnreadFiles(const Case& theCase, const std::string& dictionary, Log& log)
{
    for (const char* relative : optionalFiles) {
        const std::string found = lookalikeOf(theCase, relative);
        if (found.empty() || fs::path(dictionary).lexically_normal() == fs::path(found)) continue;
        log.warning(format("{} is not read: is it meant for {}, which is not there? Rename it, or "
                           "move it out of the folder",
                           found, relative));
    }
}

} // namespace fpm
