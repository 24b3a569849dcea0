#include "case/RunStatus.h"

#include "base/Error.h"
#include "base/Format.h"
#include "base/Machine.h"
#include "case/CaseLock.h"
#include "case/StatusFile.h"
#include "dictionary/Dictionary.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <limits>
#include <random>
#include <thread>
#include <utility>

namespace fpm {

namespace {

constexpr std::array states{
    std::pair{RunState::running, "running"}, std::pair{RunState::finished, "finished"},
    std::pair{RunState::stopped, "stopped"}, std::pair{RunState::failed, "failed"}};

std::optional<RunStatus> parse(const Dictionary& file)
{
    RunStatus status;
    const std::string word = file.wordOr("state", "");
    const auto* state = std::find_if(states.begin(), states.end(),
                                     [&](const auto& one) { return one.second == word; });
    if (state == states.end()) return std::nullopt;
    status.state = state->first;
    status.runId = file.wordOr("runId", "");
    status.time = file.numberOr("time", 0);
    status.steps = file.integerOr("steps", 0, 0, std::numeric_limits<std::int64_t>::max());
    status.wallSeconds = file.numberOr("wallSeconds", 0);
    status.process = int(file.integerOr("pid", 0, 0, std::numeric_limits<int>::max()));
    status.host = file.wordOr("host", "");
    status.started = file.wordOr("started", "");
    status.failedFile = file.wordOr("failedFile", "");
    return status;
}

/// The text of a status file that is not just being rewritten.
std::optional<std::string> readText(const std::filesystem::path& file)
{
    constexpr int tries = 50;
    for (int i = 0; i < tries; ++i) {
        std::string content(1 << 16, '\0');
        std::ifstream stream(file, std::ios::binary);
        stream.read(content.data(), std::streamsize(content.size()));
        content.resize(std::size_t(stream.gcount()));
        if (auto text = statusText(content)) return text;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return std::nullopt;
}

/// As a string of a dictionary holds it.
std::string quotable(std::string text)
{
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return c == '"' || c == '\\' || (c >= 0 && c < ' '); }, '?');
    return text;
}

/// What the solver wrote of the reason, as far as it can be printed.
std::string reasonIn(const std::filesystem::path& caseRoot)
{
    std::string line;
    const auto file = caseRoot / "why.txt";
    std::error_code failure;
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, failure)))
        return "";
    std::ifstream stream(file);
    std::getline(stream, line);
    line.resize(std::min<std::size_t>(line.size(), 300));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line;
}

} // namespace

std::string nameOf(RunState state)
{
    for (const auto& [known, name] : states)
        if (known == state) return name;
    return "died";
}

std::string RunStatus::text() const
{
    return format("state {};\nrunId \"{}\";\ntime {};\nsteps {};\nwallSeconds {};\n", nameOf(state),
                  runId, toText(time), steps, wallSeconds)
           + format("pid {};\nhost \"{}\";\nstarted \"{}\";\n", process, host, started)
           + (failedFile.empty() ? "" : format("failedFile \"{}\";\n", quotable(failedFile)))
           + more;
}

std::optional<RunStatus> readStatus(const std::filesystem::path& caseRoot)
{
    std::error_code failure;
    const auto file = caseRoot / statusFile;
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, failure)))
        return std::nullopt;
    std::optional<RunStatus> status;
    try {
        if (const auto text = readText(file)) status = parse(Dictionary::parse(*text, statusFile));
    } catch (const Error&) {
        return std::nullopt;
    }
    if (status && status->state == RunState::running
        && !holdsCase(caseRoot, status->process, status->host))
        status->state = RunState::died;
    return status;
}

std::string describe(const RunStatus& status, const std::filesystem::path& caseRoot)
{
    const std::string time = toText(status.time, 6);
    std::string text = "run";
    if (!status.runId.empty()) text += " " + status.runId;
    switch (status.state) {
    case RunState::running:
        return text + " is running, at time " + time;
    case RunState::stopped:
        return text + " was stopped at time " + time;
    case RunState::died:
        return text
               + format(" died after time {}: process {} on {} is gone", time, status.process,
                        status.host);
    default:
        break;
    }
    text += format(" {} at time {}", nameOf(status.state), time);
    std::string reason = status.state == RunState::failed ? reasonIn(caseRoot) : "";
    if (!status.failedFile.empty()) reason = format("it could not write {}", status.failedFile);
    return reason.empty() ? text : text + ": " + reason;
}

std::string makeRunId()
{
    std::string id;
    for (const char c : utcDate()) // 2025-01-31T12:00:00Z
        if (c >= '0' && c <= '9')
            id += c;
        else if (c == 'T')
            id += '-';
    id += '-';
    std::uint32_t bits = std::random_device{}();
    for (int digit = 0; digit < 8; ++digit, bits >>= 4) id += "0123456789abcdef"[bits & 15];
    return id;
}

} // namespace fpm
