#include "advise/ReducedCase.h"

#include "advise/Symmetry.h"
#include "advise/SymmetryEdits.h"
#include "base/Format.h"
#include "mesh/MeshFile.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"

#include <algorithm>
#include <fstream>
#include <optional>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// A copy that is removed at the end of its scope, unless it was kept.
class Draft
{
public:
    explicit Draft(const fs::path& target)
        : place_(OutputFolder::make(target.parent_path())),
          target_(target.filename().string()),
          name_(format(".{}.draft", target_))
    {
        removeCopy(place_, name_);
        copy_.emplace(makeCopyFolder(place_, name_));
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft()
    {
        if (kept_) return;
        try {
            removeCopy(place_, name_);
        } catch (const std::exception&) {
            // The next call removes it, or says why it cannot.
        }
    }
    const OutputFolder& output() const { return *copy_; }
    void keep()
    {
        keepCopy(*copy_);
        place_.rename(name_, target_);
        kept_ = true;
    }

private:
    OutputFolder place_;
    std::string target_, name_;
    std::optional<OutputFolder> copy_;
    bool kept_ = false;
};

/// Renames a file that did not make this case.
void setAside(const OutputFolder& folder, const std::string& file, const std::string& name)
{
    if (fs::exists(folder.path(file))) folder.rename(file, name);
}

/// A cut mesh is not made by fpmMesh: its line leaves the scripts.
void forgetMesher(const OutputFolder& folder, const std::string& script)
{
    std::ifstream stream(folder.path(script));
    if (!stream) return;
    std::string text, line;
    while (std::getline(stream, line))
        if (line.find("runApplication fpmMesh") == line.npos) text += line + "\n";
    folder.write(script, text);
}

/// The surfaces of the cut case are those of the whole one, as far as they are kept.
void requireSurfaces(const Model& whole, const Model& half, const Cut& cut)
{
    for (const ContactPair& pair : whole.contactPairs) {
        const auto same = [&](const ContactPair& p) { return p.name == pair.name; };
        const auto left = std::find_if(half.contactPairs.begin(), half.contactPairs.end(), same);
        const auto nodes =
            std::count_if(pair.contactorNodes.begin(), pair.contactorNodes.end(),
                          [&](Index n) { return cut.keeps(whole.mesh.points[std::size_t(n)]); });
        const auto sides = std::count_if(
            pair.targetSides.begin(), pair.targetSides.end(),
            [&](const ElementSide& side) { return cut.keeps(whole.mesh, side.element); });
        if (left == half.contactPairs.end() || std::size_t(nodes) != left->contactorNodes.size()
            || std::size_t(sides) != left->targetSides.size())
            throw Error(ExitCode::internal,
                        format("the cut changed the surfaces of contact pair {}", pair.name));
    }
}

std::vector<std::string> cutNotes(const Model& model, const Cut& cut)
{
    std::vector<std::string> notes;
    std::string planes;
    for (const MirrorPlane& plane : cut.planes())
        planes += (planes.empty() ? "" : ", ") + plane.text();
    notes.push_back(format("the mesh is cut at {}: one of {} equal parts is computed. "
                           "constant/mesh.vtkhdf is the mesh; do not run fpmMesh. "
                           "system/meshDict.whole is how the whole one was made",
                           planes, cut.factor()));
    for (const History& history : model.control.histories) {
        if (history.kind == History::Kind::reaction)
            notes.push_back(format("history '{}' has the factor {}: it gives the force of the "
                                   "whole in the planes; across them the whole has none",
                                   history.name, toText(history.factor * cut.factor())));
        else if (history.kind == History::Kind::energies)
            notes.push_back(format("history '{}': multiply energies by {}; balance and "
                                   "kineticShare are those of the whole",
                                   history.name, cut.factor()));
        else if (history.kind == History::Kind::contactForces)
            notes.push_back(format("history '{}': multiply forces by {}; across the planes the "
                                   "whole has none",
                                   history.name, cut.factor()));
        else if (history.kind == History::Kind::part)
            notes.push_back(
                format("history '{}': multiply momentum and kinetic energy by {}; across "
                       "the planes the whole has no momentum, and its centre lies in "
                       "them",
                       history.name, cut.factor()));
        else if (history.kind == History::Kind::rigidBody)
            notes.push_back(format("history '{}': multiply forces and moments by {}; across the "
                                   "planes the whole has none",
                                   history.name, cut.factor()));
    }
    notes.push_back("tables of system/probeDict with operation sum are sums over the part that is "
                    "kept; pictures are mirrored to the whole");
    notes.push_back("what breaks the symmetry of the whole (buckling to one side, an "
                    "imperfection) cannot happen here");
    return notes;
}

std::vector<std::string> cutCase(const OutputFolder& folder, Log& log)
{
    const Case draft(folder.path());
    updateContact(draft, log);
    Log quiet = Log::quiet();
    const Model model = readModel(draft, quiet);
    const SymmetryFinding finding = symmetryFinding(model);
    if (finding.planes.empty()) {
        std::string why;
        for (const std::string& obstacle : finding.obstacles) why += format("\n  {}", obstacle);
        throw Error(ExitCode::commandLine, "there is no mirror plane to cut at:" + why);
    }
    const Cut cut = chooseCut(model, finding.planes);
    Mesh mesh = model.mesh;
    CaseEdits edits = symmetryEdits(model, draft, cut, mesh);
    const std::vector<std::string> notes = cutNotes(model, cut);
    edits.notes.insert(edits.notes.begin(), notes.begin(), notes.end());
    edits.make(draft, folder);
    writeMesh(folder, cutMesh(mesh, cut));
    setAside(folder, "system/meshDict", "system/meshDict.whole");
    forgetMesher(folder, "Allrun");
    updateContact(draft, log);
    requireSurfaces(model, readModel(draft, quiet), cut);
    return edits.notes;
}

void writeReadme(const OutputFolder& folder,
                 const fs::path& original,
                 const std::vector<Advice>& advice,
                 const std::vector<std::string>& cutNotes)
{
    setAside(folder, "README.md", "README.original.md");
    std::string text =
        format("# {}, reduced\n\nWritten by fpmAdvise from the case `{}`. What differs from it, "
               "and what must be known to read the results:\n\n",
               original.filename().string(), original.filename().string());
    for (const Advice& one : advice) {
        text += format("- {}, {}: {}. Price: {}.\n", one.kind, one.subject, one.reason,
                       one.measured.empty() ? one.price : one.price + "; " + one.measured);
        for (const std::string& note : one.edits.notes) text += format("  - {}.\n", note);
    }
    if (!cutNotes.empty()) text += "- symmetry:\n";
    for (const std::string& note : cutNotes) text += format("  - {}.\n", note);
    folder.write("README.md", text);
}

} // namespace

SymmetryFinding symmetryFinding(const Model& model)
{
    SymmetryFinding finding;
    finding.elements = model.mesh.hexahedra.size();
    for (const MirrorMap& map : findSymmetry(model)) {
        if (map.holds())
            finding.planes.push_back(map.plane);
        else
            finding.obstacles.push_back(format("{}: {}", map.plane.text(), map.obstacle));
    }
    return finding;
}

void writeReducedCase(const Case& theCase,
                      const std::vector<Advice>& advice,
                      bool cut,
                      const fs::path& target,
                      Log& log)
{
    if (fs::exists(fs::symlink_status(target)))
        throw Error(ExitCode::commandLine, format("{} exists already", target.string()),
                    "name a folder that does not exist; nothing is written over");
    const fs::path place = fs::weakly_canonical(target);
    const fs::path inside = place.lexically_relative(fs::canonical(theCase.root()));
    if (!inside.empty() && *inside.begin() != "..")
        throw Error(ExitCode::commandLine, format("{} lies in the case itself", target.string()),
                    "name a folder outside of it");
    Draft draft(place);
    const OutputFolder& output = draft.output();
    copyCase(theCase, output);
    output.copy(theCase.path(meshFile), meshFile);
    CaseEdits edits;
    for (const Advice& one : advice) edits.add(one.edits);
    edits.make(theCase, output);
    std::vector<std::string> notes;
    if (cut) notes = cutCase(output, log);
    const Case made(output.path());
    updateContact(made, log);
    readModel(made, log);
    writeReadme(output, theCase.root(), advice, notes);
    draft.keep();
    log.line(format("written: {}", target.string()));
}

} // namespace fpm
