#include "study/Pipeline.h"

#include "base/ChildProcess.h"
#include "base/Error.h"
#include "base/Format.h"
#include "base/Machine.h"
#include "base/Version.h"
#include "case/PerformanceRecord.h"
#include "io/Checksum.h"

#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

namespace fpm {

namespace fs = std::filesystem;

namespace {

constexpr std::array programs{"fpmMesh", "fpmSetContact", "fpmExplicit", "fpmProbe"};

std::string textOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Ends that say nothing about the run: it was stopped from outside, or the disk is full.
void requireResult(const std::string& program, const ProcessEnd& end, const fs::path& log)
{
    const auto code = ExitCode(end.exitCode);
    const bool stopped = code == ExitCode::stopped || end.signal == SIGINT || end.signal == SIGTERM
                         || end.signal == SIGHUP;
    if (Interrupt::raised() || stopped)
        throw Error(ExitCode::stopped, format("interrupted in {}", program),
                    "finished runs are kept: start again to go on");
    if (code == ExitCode::fileIo || code == ExitCode::caseLocked)
        throw Error(code, format("{} could not read or write its files", program),
                    format("its words are in {}; finished runs are kept: start again to go on",
                           log.string()));
}

/// To microseconds: digits beyond mean nothing and would only be cut by the table.
double rounded(double seconds)
{
    return std::round(1e6 * seconds) / 1e6;
}

std::string stateOf(const std::string& program, const ProcessEnd& end, double timeLimit)
{
    if (end.succeeded()) return "ok";
    if (end.timedOut) return pastTimeLimit(program, timeLimit);
    if (end.signal != 0) return format("{}:signal{}", program, end.signal);
    return stateOf(program, ExitCode(end.exitCode));
}

} // namespace

Pipeline::Pipeline(fs::path binFolder) : bin_(std::move(binFolder))
{
    Checksum sum;
    for (const auto* program : programs) {
        const auto file = bin_ / program;
        if (::access(file.c_str(), X_OK) != 0)
            throw Error(ExitCode::fileIo, format("there is no program {}", file.string()),
                        "keep the programs in one folder");
        sum.add(withoutRevision(textOf(file)));
    }
    key_ = sum.text();
}

Pipeline Pipeline::beside()
{
    return Pipeline(fs::read_symlink("/proc/self/exe").parent_path());
}

RunRow
Pipeline::run(const fs::path& folder, bool tables, double timeLimit, const Continuation& from) const
{
    RunRow row;
    row.host = hostName().empty() ? "-" : hostName();
    double left = timeLimit - from.wallSeconds;
    const bool hasMesh = from.goesOn && fs::exists(folder / "constant/mesh.vtkhdf");
    for (const std::string program : programs) {
        if (hasMesh && (program == "fpmMesh" || program == "fpmSetContact")) continue;
        if (program == "fpmMesh" && !fs::exists(folder / "system/meshDict")) continue;
        if (program == "fpmSetContact" && !fs::exists(folder / "system/contactDict")) continue;
        if (program == "fpmProbe" && !tables) continue;
        std::vector<std::string> command{(bin_ / program).string(), "-noLog"};
        if (program == "fpmProbe") command.push_back("-tables");
        if (program == "fpmExplicit" && from.goesOn) command.push_back("-continue");
        const auto log = folder / ("log." + program);
        const auto end = runProcess(command, folder, log, left);
        left -= end.wall;
        requireResult(program, end, log);
        if (program == "fpmExplicit") {
            row.wall = rounded(from.wallSeconds + end.wall);
            row.cpu = rounded(from.cpuSeconds + end.cpu);
            row.memory = std::round(1e-6 * end.peakMemory);
            const auto told = readPerformance(folder).value_or(PerformanceRecord());
            row.elements = double(told.elements);
            row.steps = double(told.steps);
            row.nsPerElementStep = told.nsPerElementStep.value_or(0);
        }
        row.state = stateOf(program, end, timeLimit);
        if (!end.succeeded()) break;
    }
    return row;
}

} // namespace fpm
