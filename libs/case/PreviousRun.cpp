#include "case/PreviousRun.h"

#include "base/Error.h"
#include "base/Format.h"
#include "case/CheckpointLabel.h"
#include "case/LaterResults.h"
#include "case/RunStatus.h"
#include "io/FolderTree.h"
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
        if (isPlainFolder(root_ / checkpointFolder)) addCheckpoints();
        // Laid out as the case, of the same run.
        if (isPlainFolder(root_ / laterFolder) && root_.filename() != laterFolder)
            for (const std::string& file : ResultSearch(root_ / laterFolder).take())
                files_.push_back(std::string(laterFolder) + "/" + file);
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

    /// Whole or cut short.
    void addCheckpoints()
    {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(root_ / checkpointFolder, error)) {
            const std::string name = entry.path().filename().string();
            const bool isOurs = (name.starts_with("state.") || name == "next.h5")
                                && name.ends_with(".h5") && isPlainFile(entry.path());
            if (isOurs) files_.push_back(std::string(checkpointFolder) + "/" + name);
        }
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
void prune(const OutputFolder& output, const std::string& file)
{
    for (auto folder = fs::path(file).parent_path(); !folder.empty(); folder = folder.parent_path())
        if (!output.remove(folder.string())) return;
}

void removeFiles(const OutputFolder& output, const std::vector<std::string>& files)
{
    for (const std::string& file : files) {
        output.remove(file);
        prune(output, file);
    }
}

[[noreturn]] void refusePrevious(const fs::path& path, const std::string& what)
{
    throw Error(ExitCode::fileIo, format("'{}' {}", path.string(), what),
                "results of the earlier run go into previous/: rename what is there, or set "
                "previousRun remove in system/controlDict");
}

void moveFile(const OutputFolder& output, const std::string& file)
{
    const std::string target = std::string(previousFolder) + "/" + file;
    if (std::error_code error; fs::exists(fs::symlink_status(output.path(target), error)))
        refusePrevious(output.path(target), "is in the way");
    output.rename(file, target);
    prune(output, file);
}

void setMarker(const OutputFolder& output, const char* state)
{
    output.write(std::string(previousFolder) + "/" + markerFile, state);
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

/// Gives a mesh a further name where it has one place of its own, else copies it.
void linkMesh(const OutputFolder& output, const std::string& mesh, const std::string& target)
{
    if (!isPlainFile(output.path(mesh)) || !output.link(mesh, target))
        output.copy(output.path(mesh), target);
}

/// Frames are shown through a link to the mesh: it goes with them, from where it is still there.
void moveMesh(const OutputFolder& output)
{
    const std::string target = std::string(previousFolder) + "/" + meshFile;
    const std::string checksum = meshOfFrames(output.path(previousFolder));
    for (const char* mesh : {keptMesh, meshFile}) {
        if (fs::exists(fs::symlink_status(output.path(target)))) break;
        if (hasChecksum(output.path(mesh), checksum)) linkMesh(output, mesh, target);
    }
}

/// Leaves what a person has put there.
void emptyPrevious(const OutputFolder& previous)
{
    auto files = resultFiles(previous.path());
    if (isPlainFile(previous.path(meshFile))) files.emplace_back(meshFile);
    removeFiles(previous, files);
}

/// Room in `previous` for what is moved next.
void openPrevious(const OutputFolder& output)
{
    const fs::path previous = output.path(previousFolder);
    std::error_code error;
    const bool isNew = !fs::exists(fs::symlink_status(previous, error))
                       || (isPlainFolder(previous) && fs::is_empty(previous, error));
    if (!isNew && !isPreviousRun(previous)) refusePrevious(previous, "was not made by fpmExplicit");
    if (!isNew) emptyPrevious(output.inner(previousFolder));
    setMarker(output, moving);
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

void keepResults(const OutputFolder& output, std::vector<std::string> files, Log& log)
{
    const fs::path previous = output.path(previousFolder);
    const bool goesOn = isPreviousRun(previous) && isMoving(previous);
    if (files.empty() && !goesOn) return;
    const std::string run = runOf(output.path());
    if (!goesOn && !resultFiles(previous).empty() && hasOnlyStarted(output.path(), files)) {
        std::reverse(files.begin(), files.end()); // the status last, so that a rest is known again
        removeFiles(output, files);
        return log.line(
            format("removed what {} left at its start; {}/ is kept", run, previousFolder));
    }
    if (!goesOn) openPrevious(output);
    for (const std::string& file : files) moveFile(output, file);
    moveMesh(output);
    setMarker(output, complete);
    log.line(format("moved into {}/ what {} left: {}", previousFolder, run,
                    counts(resultFiles(previous))));
}

void removeResults(const OutputFolder& output, const std::vector<std::string>& files, Log& log)
{
    const fs::path previous = output.path(previousFolder);
    if (isPreviousRun(previous) && isMoving(previous)) setMarker(output, complete);
    if (files.empty()) return;
    const std::string run = runOf(output.path());
    removeFiles(output, files);
    log.line(format("removed what {} left: {}", run, counts(files)));
}

/// Before anything is moved: a run would be refused at its first file behind a link.
void refuseLinks(const OutputFolder& output)
{
    for (const char* folder : {"postProcessing", previousFolder})
        if (std::error_code error; fs::is_symlink(fs::symlink_status(output.path(folder), error)))
            output.openFolder(folder);
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

void clearForRun(const OutputFolder& theCase, const std::string& mode, Log& log)
{
    const fs::path caseRoot = theCase.path();
    const auto files = resultFiles(caseRoot);
    if (mode == "refuse" && !files.empty())
        throw Error(ExitCode::fileIo,
                    format("the case holds results of {}: {}", runOf(caseRoot), counts(files)),
                    "move them away, or set previousRun keep or remove in system/controlDict");
    refuseLinks(theCase);
    if (mode == "remove")
        removeResults(theCase, files, log);
    else
        keepResults(theCase, files, log);
    if (isPlainFile(caseRoot / keptMesh)) theCase.remove(keptMesh);
}

void keepMeshOfFrames(const fs::path& caseRoot)
{
    if (!hasChecksum(caseRoot / meshFile, meshOfFrames(caseRoot))) return;
    const OutputFolder output(caseRoot);
    output.remove(keptMesh);
    linkMesh(output, meshFile, keptMesh);
}

void sweepTemporaries(const fs::path& caseRoot)
{
    std::error_code error;
    const OutputFolder output(caseRoot);
    removeTemporaries(output, "", false);
    for (const auto& entry : fs::directory_iterator(caseRoot, error)) {
        const auto name = entry.path().filename().string();
        if (!fs::exists(entry.path() / "system", error) && name != "postProcessing")
            removeTemporaries(output, name, false);
    }
    // fpmProbe writes there without the lock.
    const std::string results = "postProcessing";
    if (!isPlainFolder(caseRoot / results)) return;
    removeTemporaries(output, results, true);
    for (const auto& entry : fs::directory_iterator(caseRoot / results, error)) {
        if (!isPlainFolder(entry.path())) continue;
        const std::string object = results + "/" + entry.path().filename().string();
        removeTemporaries(output, object, true);
        for (const auto& inner : fs::directory_iterator(entry.path(), error))
            removeTemporaries(output, object + "/" + inner.path().filename().string(), true);
    }
}

} // namespace fpm
