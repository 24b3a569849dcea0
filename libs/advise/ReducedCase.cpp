#include "advise/ReducedCase.h"

#include "advise/Symmetry.h"
#include "advise/SymmetryEdits.h"
#include "base/Format.h"
#include "io/AtomicFile.h"
#include "mesh/MeshFile.h"
#include "model/ContactSetup.h"
#include "model/readModel.h"

#include <algorithm>
#include <fstream>

namespace fpm {

namespace fs = std::filesystem;

namespace {

const char* const meshFile = "constant/mesh.vtkhdf";

/// Removes a folder at the end of its scope, unless it was kept.
class Draft
{
public:
    explicit Draft(fs::path folder) : folder_(std::move(folder)) {}
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft()
    {
        std::error_code ignored;
        if (!folder_.empty()) fs::remove_all(folder_, ignored);
    }
    const fs::path& folder() const { return folder_; }
    void keepAs(const fs::path& target)
    {
        fs::rename(folder_, target);
        folder_.clear();
    }

private:
    fs::path folder_;
};

/// Renames a file that did not make this case.
void setAside(const fs::path& folder, const std::string& file, const std::string& name)
{
    if (fs::exists(folder / file)) fs::rename(folder / file, folder / name);
}

/// A cut mesh is not made by fpmMesh: its line leaves the scripts.
void forgetMesher(const fs::path& script)
{
    std::ifstream stream(script);
    if (!stream) return;
    std::string text, line;
    while (std::getline(stream, line))
        if (line.find("runApplication fpmMesh") == line.npos) text += line + "\n";
    const auto permissions = fs::status(script).permissions();
    writeFileAtomically(script, text);
    fs::permissions(script, permissions);
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

std::vector<std::string> cutCase(const fs::path& folder, Log& log)
{
    const Case draft(folder);
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
    writeMesh(folder / meshFile, cutMesh(mesh, cut));
    setAside(folder, "system/meshDict", "system/meshDict.whole");
    forgetMesher(folder / "Allrun");
    updateContact(draft, log);
    requireSurfaces(model, readModel(draft, quiet), cut);
    return edits.notes;
}

void writeReadme(const fs::path& folder,
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
    writeFileAtomically(folder / "README.md", text);
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
    fs::create_directories(place.parent_path());
    Draft draft(place.parent_path() / format(".{}.draft", place.filename().string()));
    fs::remove_all(draft.folder());
    copyCase(theCase, draft.folder());
    fs::create_directories(draft.folder() / "constant");
    fs::copy_file(theCase.path(meshFile), draft.folder() / meshFile,
                  fs::copy_options::overwrite_existing);
    CaseEdits edits;
    for (const Advice& one : advice) edits.add(one.edits);
    edits.make(theCase, draft.folder());
    std::vector<std::string> notes;
    if (cut) notes = cutCase(draft.folder(), log);
    const Case made(draft.folder());
    updateContact(made, log);
    readModel(made, log);
    writeReadme(draft.folder(), theCase.root(), advice, notes);
    draft.keepAs(place);
    log.line(format("written: {}", target.string()));
}

} // namespace fpm
