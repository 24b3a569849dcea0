#include "case/PreviousRun.h"

#include "base/Error.h"
#include "base/Format.h"
#include "case/Confinement.h"
#include "case/RunStatus.h"
#include "io/AtomicFile.h"
#include "io/Frames.h"
#include "io/RunMark.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace fpm {

namespace fs = std::filesystem;

namespace {

constexpr const char* markerFile = ".fpmPrevious";
constexpr const char* meshFile = "constant/mesh.vtkhdf";
constexpr const char* keptMesh = ".mesh.vtkhdf"; // of frames in the case, once there is another
constexpr const char* moving = "state moving;\n";
constexpr const char* complete = "state complete;\n";

bool isPlainFile(const fs::path& file)
{
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(file, error));
}

bool isPlainFolder(const fs::path& folder)
{
    std::error_code error;
    return fs::is_directory(fs::symlink_status(folder, error));
}

bool isOneOf(const std::string& name, std::initializer_list<const char*> names)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Collects the result files of one folder laid out as a case.
class ResultSearch
{
public:
    explicit ResultSearch(fs::path root) : root_(std::move(root))
    {
        // The status goes first: what is left of a run half moved is never taken for the whole.
        // Runs of older versions left performance.json, which bears no mark.
        for (const char* name : {"status", "why.txt", "case.vtkhdf.series", "case.hdf.series",
                                 "postProcessing/performance/0/performance.json"})
            if (isPlainFile(root_ / name)) files_.emplace_back(name);
        for (const std::string& name : foldersIn(""))
            if (!isOneOf(name, {"constant", "system", "postProcessing", previousFolder})
                && !name.starts_with('.'))
                addFrames(name);
        if (isPlainFolder(root_ / "postProcessing")) addMarked("postProcessing", 2);
    }
    std::vector<std::string> take() { return std::move(files_); }

private:
    std::vector<std::string> foldersIn(const std::string& folder) const
    {
        std::vector<std::string> names;
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(root_ / folder, error))
            if (isPlainFolder(entry.path())) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    void addFrames(const std::string& folder)
    {
        const auto add = [&](const std::string& file) {
            if (isFrame(root_, file)) files_.push_back(file);
        };
        add(folder + "/fields.vtkhdf");
        for (const std::string& name : foldersIn(folder))
            add(folder + "/" + name + "/fields.vtkhdf");
    }

    /// What fpmChart and fpmStability left is of many runs, in copies of the case.
    void addMarked(const std::string& folder, int depth)
    {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(root_ / folder, error)) {
            const std::string file = folder + "/" + entry.path().filename().string();
            const auto mark = markOf(entry.path());
            if (mark && mark->file == file) files_.push_back(file);
        }
        if (depth == 0) return;
        for (const std::string& name : foldersIn(folder))
            if (folder != "postProcessing" || !isOneOf(name, {"chart", "stability"}))
                addMarked(folder + "/" + name, depth - 1);
    }

    fs::path root_;
    std::vector<std::string> files_;
};

bool isMoving(const fs::path& previous)
{
    std::string line;
    std::ifstream stream(previous / markerFile);
    std::getline(stream, line);
    return line + "\n" == moving;
}

/// "6 frames, 3 tables, 2 pictures".
std::string counts(const std::vector<std::string>& files)
{
    std::size_t frames = 0, tables = 0, pictures = 0;
    for (const std::string& file : files) {
        const std::string ending = fs::path(file).extension().string();
        frames += file.ends_with("/fields.vtkhdf");
        tables += isOneOf(ending, {".dat", ".csv"});
        pictures += isOneOf(ending, {".svg", ".png"});
    }
    return format("{} frames, {} tables, {} pictures", frames, tables, pictures);
}

/// The run that `status` names, in the case or where it was moved to already.
std::string runOf(const fs::path& caseRoot)
{
    for (const fs::path& folder : {caseRoot, caseRoot / previousFolder}) {
        const auto status = readStatus(folder);
        if (status && !status->runId.empty()) return "run " + status->runId;
        if (!isMoving(caseRoot / previousFolder)) break;
    }
    return "an earlier run";
}

/// Removes the folders above a file as far as they are empty now.
void prune(const fs::path& root, const std::string& file)
{
    std::error_code error;
    for (auto folder = fs::path(file).parent_path(); !folder.empty(); folder = folder.parent_path())
        if (!fs::remove(root / folder, error)) return;
}

void removeFiles(const fs::path& root, const std::vector<std::string>& files)
{
    for (const std::string& file : files) {
        fs::remove(root / file);
        prune(root, file);
    }
}

[[noreturn]] void refusePrevious(const fs::path& path, const std::string& what)
{
    throw Error(ExitCode::fileIo, format("'{}' {}", path.string(), what),
                "results of the earlier run go into previous/: rename what is there, or set "
                "previousRun remove in system/controlDict");
}

void moveFile(const fs::path& root, const std::string& file)
{
    const fs::path target = confinedPath(root, std::string(previousFolder) + "/" + file);
    fs::create_directories(target.parent_path());
    if (fs::exists(fs::symlink_status(target))) refusePrevious(target, "is in the way");
    std::error_code error;
    fs::rename(root / file, target, error);
    if (error)
        refusePrevious(target, "cannot be made of the same file in the case: " + error.message());
    prune(root, file);
}

void setMarker(const fs::path& previous, const char* state)
{
    writeFileAtomically(previous / markerFile, std::string_view(state));
}

/// Checksum of the mesh that the frames of a folder belong to; empty where none can be read.
std::string meshOfFrames(const fs::path& root)
{
    try {
        const auto frames = listFrames(root);
        return frames.empty() ? "" : frames.front().meshChecksum;
    } catch (const Error&) {
        return "";
    }
}

/// Whether a mesh file can be read and has this checksum.
bool hasChecksum(const fs::path& mesh, const std::string& checksum)
{
    try {
        return !checksum.empty() && meshChecksumIn(mesh) == checksum;
    } catch (const Error&) {
        return false;
    }
}

/// Frames are shown through a link to the mesh: it goes with them, from where it is still there.
void moveMesh(const fs::path& root)
{
    const fs::path previous = root / previousFolder, target = previous / meshFile;
    const std::string checksum = meshOfFrames(previous);
    for (const char* place : {keptMesh, meshFile}) {
        const fs::path mesh = root / place;
        if (fs::exists(fs::symlink_status(target))) break;
        if (!hasChecksum(mesh, checksum)) continue;
        fs::create_directories(target.parent_path());
        std::error_code error;
        fs::create_hard_link(fs::canonical(mesh), target, error);
        if (error) fs::copy_file(mesh, target);
    }
}

/// Leaves what a person has put there.
void emptyPrevious(const fs::path& previous)
{
    auto files = resultFiles(previous);
    if (isPlainFile(previous / meshFile)) files.emplace_back(meshFile);
    removeFiles(previous, files);
}

/// Room in `previous` for what is moved next.
void openPrevious(const fs::path& previous)
{
    std::error_code error;
    const bool isNew = !fs::exists(fs::symlink_status(previous, error))
                       || (isPlainFolder(previous) && fs::is_empty(previous, error));
    if (!isNew && !isPreviousRun(previous)) refusePrevious(previous, "was not made by fpmExplicit");
    if (!isNew) emptyPrevious(previous);
    setMarker(previous, moving);
}

/// Whether the earlier run came no further than its start: that is not worth the results of the run
/// before it.
bool hasOnlyStarted(const fs::path& root, const std::vector<std::string>& files)
{
    const auto status = readStatus(root);
    const auto frames = std::count_if(files.begin(), files.end(), [](const std::string& file) {
        return file.ends_with("/fields.vtkhdf");
    });
    return status && status->steps == 0 && frames <= 1;
}

void keepResults(const fs::path& root, std::vector<std::string> files, Log& log)
{
    const fs::path previous = root / previousFolder;
    const bool goesOn = isPreviousRun(previous) && isMoving(previous);
    if (files.empty() && !goesOn) return;
    const std::string run = runOf(root);
    if (!goesOn && !resultFiles(previous).empty() && hasOnlyStarted(root, files)) {
        std::reverse(files.begin(), files.end()); // the status last, so that a rest is known again
        removeFiles(root, files);
        return log.line(
            format("removed what {} left at its start; {}/ is kept", run, previousFolder));
    }
    if (!goesOn) openPrevious(previous);
    for (const std::string& file : files) moveFile(root, file);
    moveMesh(root);
    setMarker(previous, complete);
    log.line(format("moved into {}/ what {} left: {}", previousFolder, run,
                    counts(resultFiles(previous))));
}

void removeResults(const fs::path& root, const std::vector<std::string>& files, Log& log)
{
    const fs::path previous = root / previousFolder;
    if (isPreviousRun(previous) && isMoving(previous)) setMarker(previous, complete);
    if (files.empty()) return;
    const std::string run = runOf(root);
    removeFiles(root, files);
    log.line(format("removed what {} left: {}", run, counts(files)));
}

/// Nothing behind a link is moved: it may be another case's, or on another disk.
void warnOfLinks(const fs::path& root, Log& log)
{
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(root / "postProcessing", error)))
        log.warning("postProcessing is a link: tables and pictures of earlier runs stay in it");
}

} // namespace

std::vector<std::string> resultFiles(const fs::path& caseRoot)
{
    return ResultSearch(caseRoot).take();
}

bool isPreviousRun(const fs::path& folder)
{
    return isPlainFolder(folder) && isPlainFile(folder / markerFile);
}

void clearForRun(const fs::path& caseRoot, const std::string& mode, Log& log)
{
    const auto files = resultFiles(caseRoot);
    if (mode == "refuse" && !files.empty())
        throw Error(ExitCode::fileIo,
                    format("the case holds results of {}: {}", runOf(caseRoot), counts(files)),
                    "move them away, or set previousRun keep or remove in system/controlDict");
    warnOfLinks(caseRoot, log);
    if (mode == "remove")
        removeResults(caseRoot, files, log);
    else
        keepResults(caseRoot, files, log);
    if (isPlainFile(caseRoot / keptMesh)) fs::remove(caseRoot / keptMesh);
}

void keepMeshOfFrames(const fs::path& caseRoot)
{
    if (!hasChecksum(caseRoot / meshFile, meshOfFrames(caseRoot))) return;
    std::error_code error;
    fs::remove(caseRoot / keptMesh, error);
    fs::create_hard_link(fs::canonical(caseRoot / meshFile), caseRoot / keptMesh, error);
}

void sweepTemporaries(const fs::path& caseRoot)
{
    std::error_code error;
    removeTemporaries(caseRoot, false);
    for (const auto& entry : fs::directory_iterator(caseRoot, error)) {
        const bool isCase = fs::exists(entry.path() / "system", error);
        if (isCase || entry.path().filename() == "postProcessing" || !isPlainFolder(entry.path()))
            continue;
        removeTemporaries(entry.path(), false);
    }
    // fpmProbe writes there without the lock.
    const auto results = caseRoot / "postProcessing";
    if (!isPlainFolder(results)) return;
    removeTemporaries(results, true);
    for (const auto& entry : fs::directory_iterator(results, error)) {
        if (!isPlainFolder(entry.path())) continue;
        removeTemporaries(entry.path(), true);
        for (const auto& inner : fs::directory_iterator(entry.path(), error))
            if (isPlainFolder(inner.path())) removeTemporaries(inner.path(), true);
    }
}

} // namespace fpm
