#include "advise/Trial.h"

#include "advise/ReducedCase.h"
#include "base/ChildProcess.h"
#include "base/Format.h"
#include "io/FolderTree.h"
#include "mesh/MeshFile.h"
#include "model/readModel.h"
#include "study/Curve.h"
#include "study/Pipeline.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// A folder for runs, removed with all they leave.
class Workshop
{
public:
    Workshop()
    {
        std::string pattern = (fs::temp_directory_path() / "fpmAdvise.XXXXXX").string();
        if (!::mkdtemp(pattern.data()))
            throw Error(ExitCode::fileIo, format("cannot make {}", pattern));
        path_ = pattern;
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    ~Workshop()
    {
        try {
            removeTree(OutputFolder(path_.parent_path()), path_.filename().string());
        } catch (const std::exception&) {
            // What is left lies in the folder for temporary files.
        }
    }
    fs::path at(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

RunRow runWhole(const fs::path& folder, const std::string& what)
{
    const RunRow row = Pipeline::beside().run(folder, false);
    if (!row.succeeded())
        throw Error(ExitCode::numericalStop, format("{} failed: {}", what, causeOf(row.state)),
                    "run the case itself first: what it says there holds here");
    return row;
}

/// How a column of the reduced run compares with that of the whole: times this; 0: it does not.
double factorOf(const History& history, const std::string& column, const SymmetryFinding& cut)
{
    const double factor = cut.factor();
    using Kind = History::Kind;
    if (history.kind == Kind::energies)
        return column == "balance" || column == "kineticShare" ? 1 : factor;
    const bool ofPart = history.kind == Kind::part;
    if (ofPart && column == "kinetic") return factor;
    // About the centre of what is kept, which is not that of the whole.
    if (ofPart && column[0] == 'l') return cut.planes.empty() ? 1 : 0;
    // fx to mz; depths are no sums.
    const bool resultant = column.size() == 2 && (column[0] == 'f' || column[0] == 'm');
    // Nodes on the planes are there once in the half as in the whole.
    if (column == "active" || column == "meanDepth") return cut.planes.empty() ? 1 : 0;
    for (const MirrorPlane& plane : cut.planes)
        if (column.back() == "xyz"[plane.axis]) return 0;
    const bool summed = history.kind == Kind::contactForces || history.kind == Kind::rigidBody;
    return (summed && resultant) || (ofPart && column[0] == 'p') ? factor : 1;
}

struct ColumnError {
    std::string name;
    double error;
};

/// Root mean square of a column; of a vector's component, the largest of the three: a component
/// that is nothing but rounding is measured by the others.
double sizeOf(const Table& table, const std::string& column)
{
    double most = 0;
    const bool isVector = column.find_last_of("xyz") == column.size() - 1 && column.size() > 1;
    for (const std::string& other : table.columns) {
        const bool sibling =
            isVector && other.size() == column.size()
            && other.compare(0, other.size() - 1, column, 0, column.size() - 1) == 0;
        if (other != column && !sibling) continue;
        double sum = 0;
        for (const double value : table.values(other)) sum += value * value;
        most = std::max(most, std::sqrt(sum / double(table.rows.size())));
    }
    return most;
}

std::vector<ColumnError> errorsOf(const Model& model,
                                  const fs::path& whole,
                                  const fs::path& reduced,
                                  const SymmetryFinding& cut)
{
    std::vector<ColumnError> errors;
    for (const History& history : model.control.histories) {
        const fs::path folder = fs::path("postProcessing") / history.name / "0";
        if (!fs::exists(whole / folder)) continue;
        for (const auto& entry : fs::directory_iterator(whole / folder)) {
            const fs::path file = reduced / folder / entry.path().filename();
            if (!fs::exists(file)) continue;
            const Table a = readTable(entry.path()), b = readTable(file);
            for (const std::string& column : a.columns) {
                const double factor = factorOf(history, column, cut);
                if (column == "time" || column == "balance" || factor == 0) continue;
                Curve other{b.values("time"), b.values(column)};
                for (double& value : other.y) value *= factor;
                const double size = sizeOf(a, column);
                const double apart = distance(other, {a.values("time"), a.values(column)});
                if (size > 0)
                    errors.push_back(
                        {format("{}/{}.{}", history.name, entry.path().stem().string(), column),
                         apart / size});
            }
        }
    }
    return errors;
}

std::string largestOf(const std::vector<ColumnError>& errors)
{
    const auto most =
        std::max_element(errors.begin(), errors.end(),
                         [](const auto& a, const auto& b) { return a.error < b.error; });
    if (most == errors.end()) return "no history to compare";
    return format("no history differs by more than {} ({})", toText(most->error, 2), most->name);
}

void report(const Advice& advice,
            const RunRow& whole,
            const RunRow& reduced,
            const std::vector<ColumnError>& errors,
            Log& log)
{
    log.line(format("{}: {}", advice.kind, advice.subject));
    log.line(
        format("     time {} s -> {} s of the processors ({} % saved), {} s -> {} s of the clock",
               toText(whole.cpu, 3), toText(reduced.cpu, 3),
               toText(100 * (1 - reduced.cpu / whole.cpu), 3), toText(whole.wall, 3),
               toText(reduced.wall, 3)));
    log.line(format("     element-steps {} -> {}", toText(whole.elements * whole.steps, 4),
                    toText(reduced.elements * reduced.steps, 4)));
    log.line("     " + advice.measured);
    for (const ColumnError& error : errors)
        log.line(format("     {} differs by {}", error.name, toText(error.error, 3)));
}

} // namespace

Results pilotRun(const Case& theCase, const Model& model, double share, Log& log)
{
    const Interrupt interrupt;
    const Workshop shop;
    Log quiet = Log::quiet();
    writeReducedCase(theCase, {}, false, shop.at("pilot"), quiet);
    const Case pilot(shop.at("pilot"));
    const double end = share * model.control.endTime;
    CaseEdits edits;
    edits.set("system/controlDict", "endTime", toText(end));
    edits.set("system/controlDict", "writeInterval", toText(end / 20));
    edits.set("system/controlDict", "historyInterval", toText(end / 500));
    edits.set("system/controlDict", "functions.adviseEnergies.type", "energies");
    edits.make(pilot, pilot.output());
    log.line(format("pilot run up to {}, {} % of the whole", end, toText(100 * share, 3)));
    const RunRow row = runWhole(pilot.root(), "the pilot run");
    log.line(format("pilot: {} steps, {} s", toText(row.steps, 6), toText(row.wall, 3)));
    const auto results = readResults(pilot.root(), readModel(pilot, quiet), quiet);
    if (!results) throw Error(ExitCode::internal, "the pilot run left no frames");
    return *results;
}

void measureAdvice(const Case& theCase, const Model& model, std::vector<Advice>& advice, Log& log)
{
    const Interrupt interrupt;
    const Workshop shop;
    Log quiet = Log::quiet();
    writeReducedCase(theCase, {}, false, shop.at("whole"), quiet);
    const RunRow whole = runWhole(shop.at("whole"), "the case as it is");
    log.line(format("the case as it is: {} s", toText(whole.wall, 3)));
    for (std::size_t i = 0; i < advice.size(); ++i) {
        if (!advice[i].isMade()) continue;
        const bool cut = advice[i].kind == "symmetry";
        const fs::path folder = shop.at(format("{}", i));
        writeReducedCase(theCase, {advice[i]}, cut, folder, quiet);
        const RunRow reduced = runWhole(folder, format("the case with '{}'", advice[i].subject));
        const SymmetryFinding finding = cut ? symmetryFinding(model) : SymmetryFinding{};
        const auto errors = errorsOf(model, shop.at("whole"), folder, finding);
        advice[i].measured = "measured: " + largestOf(errors);
        report(advice[i], whole, reduced, errors, log);
    }
}

} // namespace fpm
