#include "study/CaseCopy.h"

#include "base/Format.h"
#include "case/CheckpointLabel.h"
#include "case/Confinement.h"
#include "case/LaterResults.h"
#include "case/PreviousRun.h"
#include "dictionary/EntryEdit.h"
#include "dictionary/Number.h"
#include "io/Checksum.h"
#include "io/FolderTree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <vector>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// In every copy, so that nothing else is ever removed for one.
constexpr const char* markFile = ".fpmCopy";
constexpr const char* markText = "a copy of a case, made by a program and removed by it\n";
constexpr const char* meshFile = "constant/mesh.vtkhdf";

constexpr std::array runDictionaries{
    "constant/caseProperties", "constant/partProperties", "constant/boundaryConditions",
    "0/initialConditions",     "system/meshDict",         "system/contactDict",
    "system/controlDict"};

std::string bytesOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw Error(ExitCode::fileIo, format("cannot read {}", file.string()));
    return text.str();
}

/// Whether a file or folder of the case goes into its copies.
bool isInput(const fs::path& root, const fs::path& relative)
{
    const auto name = relative.filename().string();
    if (name.starts_with('.')) return false;
    if (relative == previousFolder) return !isPreviousRun(root / relative);
    if (!relative.has_parent_path()) return !isResult(name);
    if (relative == meshFile) return !fs::exists(root / "system/meshDict");
    return relative != "0/fields.vtkhdf";
}

void copyTree(const fs::path& root, const fs::path& from, const OutputFolder& to, bool all)
{
    for (fs::recursive_directory_iterator entry(from), end; entry != end; ++entry) {
        const auto relative = entry->path().lexically_relative(from);
        if (!all && !isInput(root, relative)) {
            if (entry->is_directory()) entry.disable_recursion_pending();
            continue;
        }
        confinedPath(root, entry->path().lexically_relative(root).string());
        if (entry->is_symlink() && entry->is_directory())
            throw Error(ExitCode::fileIo,
                        format("{} is a link to a folder", entry->path().string()),
                        "copies of a case hold folders and files; put a folder in its place");
        if (entry->is_directory())
            to.inner(relative.string());
        else if (entry->is_regular_file())
            to.copy(entry->path(), relative.string());
    }
}

[[noreturn]] void refuseStranger(const fs::path& path)
{
    throw Error(
        ExitCode::fileIo,
        format("'{}' is in the way: it is not a copy that this program made", path.string()),
        "rename it, or delete it if nothing in it is needed");
}

/// Files that meshDict names.
std::vector<std::string> meshFiles(const Dictionary& meshDict)
{
    std::vector<std::string> files;
    const auto bodies = meshDict.subOrEmpty("bodies");
    for (const auto& name : bodies.keys()) {
        if (!bodies.isDictionary(name)) continue;
        const auto body = bodies.sub(name);
        if (body.has("file")) files.push_back(body.word("file"));
    }
    return files;
}

/// The canonical text of a controlDict but for entries that say how long the run goes on.
std::string withoutLength(const std::string& text)
{
    std::istringstream lines(text);
    std::string rest;
    int depth = 0;
    for (std::string line; std::getline(lines, line);) {
        const bool isLength =
            depth == 0 && (line.starts_with("endTime ") || line.starts_with("title "));
        if (!isLength) rest += line + "\n";
        depth += int(line.ends_with('{')) - int(line.starts_with('}'));
    }
    return rest;
}

} // namespace

bool isResult(const std::string& name)
{
    static const std::vector<std::string> names{"postProcessing", checkpointFolder, laterFolder,
                                                "failed",         "status",         "why.txt"};
    const bool isTime = name != "0" && readNumber(name).has_value();
    return isTime || name.starts_with("log.") || name.ends_with(".series")
           || name.ends_with(".xdmf") || std::find(names.begin(), names.end(), name) != names.end();
}

OutputFolder makeCopyFolder(const OutputFolder& output, const std::string& folder)
{
    OutputFolder copy = output.inner(folder);
    if (!fs::is_empty(copy.path())) refuseStranger(copy.path());
    copy.renew(markFile, markText);
    return copy;
}

void requireCopy(const OutputFolder& output, const std::string& folder)
{
    const fs::path path = output.path(folder);
    std::error_code error;
    output.openFolder(folder); // refuses links
    if (!fs::is_empty(path) && !fs::is_regular_file(fs::symlink_status(path / markFile, error)))
        refuseStranger(path);
}

void removeCopy(const OutputFolder& output, const std::string& folder)
{
    std::error_code error;
    if (!fs::exists(fs::symlink_status(output.path(folder), error))) return;
    requireCopy(output, folder);
    removeTree(output, folder);
}

void keepCopy(const OutputFolder& copy)
{
    copy.remove(markFile);
}

void copyCase(const Case& theCase, const OutputFolder& copy)
{
    copyTree(theCase.root(), theCase.root(), copy, false);
}

void change(const Case& theCase, const OutputFolder& copy, const CaseChange& change)
{
    if (!change.overlay.empty())
        return copyTree(theCase.root(), theCase.inside(change.overlay), copy, true);
    const auto root = fs::canonical(copy.path());
    const auto edit = setEntry(root / change.file, root, change.path, change.value);
    copy.write(edit.file.string(), edit.text);
}

CaseKeys keysOf(const fs::path& root, bool withProbes)
{
    const Case theCase(root);
    Checksum whole, some;
    const auto addBytes = [&](const std::string& bytes) { whole.add(bytes), some.add(bytes); };
    const auto addFile = [&](const std::string& file, Checksum& sum, bool butItsLength) {
        if (!theCase.hasFile(file)) return;
        const std::string text = theCase.dictionary(file).canonicalText();
        sum.add(file);
        sum.add(butItsLength ? withoutLength(text) : text);
    };
    for (const char* file : runDictionaries) {
        addFile(file, whole, false);
        addFile(file, some, file == std::string_view("system/controlDict"));
    }
    if (withProbes) addFile("system/probeDict", whole, false);
    if (theCase.hasFile("system/meshDict")) {
        for (const auto& file : meshFiles(theCase.dictionary("system/meshDict")))
            if (theCase.hasFile(file)) addBytes(bytesOf(theCase.inside(file)));
    } else if (theCase.hasFile(meshFile)) {
        addBytes(bytesOf(theCase.path(meshFile)));
    }
    return {whole.text(), some.text()};
}

void noteKey(const OutputFolder& copy, const std::string& key)
{
    copy.renew(markFile, format("{}of {}\n", markText, key));
}

std::string notedKey(const fs::path& copy)
{
    std::ifstream stream(copy / markFile);
    std::string line, of, key;
    std::getline(stream, line);
    stream >> of >> key;
    return of == "of" ? key : "";
}

void renewInputs(const fs::path& from, const OutputFolder& copy)
{
    for (fs::recursive_directory_iterator entry(from), end; entry != end; ++entry) {
        const auto relative = entry->path().lexically_relative(from);
        if (!isInput(from, relative) && entry->is_directory()) entry.disable_recursion_pending();
        if (isInput(from, relative) && relative != meshFile && entry->is_regular_file())
            copy.copy(entry->path(), relative.string());
    }
}

void removeFields(const OutputFolder& copy)
{
    const fs::path root = copy.path();
    std::vector<std::string> times, series;
    for (const auto& entry : fs::directory_iterator(root)) {
        const auto name = entry.path().filename().string();
        if (name.ends_with(".series"))
            series.push_back(name);
        else if (name != "0" && readNumber(name))
            times.push_back(name);
    }
    for (const auto& name : series) copy.remove(name);
    for (const auto& name : times) removeTree(copy, name);
    for (const char* name : {"0/fields.vtkhdf", meshFile})
        if (fs::exists(root / name) && (name[0] == '0' || fs::exists(root / "system/meshDict")))
            copy.remove(name);
}

} // namespace fpm
