#include "application/Application.h"

#include "application/CommandLine.h"
#include "base/Format.h"
#include "base/Machine.h"
#include "base/Version.h"
#include "case/CaseLock.h"
#include "case/Confinement.h"
#include "case/PreviousRun.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <new>
#include <sstream>
#include <system_error>

namespace fpm {

namespace {

namespace fs = std::filesystem;

/// Lets a reader of our output leave without killing us, and keeps files we open from taking the
/// number of a standard stream that was closed before we started.
void protectStandardStreams()
{
    std::signal(SIGPIPE, SIG_IGN);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) open("/dev/null", O_RDWR);
}

std::string valueOr(const OptionValues& options, std::string_view name, const std::string& preset)
{
    for (const auto& [option, value] : options)
        if (option == name) return value;
    return preset;
}

bool isGiven(const OptionValues& options, std::string_view name)
{
    for (const auto& option : options)
        if (option.first == name) return true;
    return false;
}

/// The manual of a dictionary, every key annotated: of its name where there is one (the solver
/// reads several), else of the application's own.
fs::path annotatedDictionary(const ApplicationInfo& info, const fs::path& dictionary)
{
    const auto manuals = etcFolder() / "caseDicts";
    std::error_code failure;
    const auto named = manuals / dictionary.filename();
    return fs::is_regular_file(named, failure) ? named
                                               : manuals / fs::path(info.dictionary).filename();
}

void listKeys(const ApplicationInfo& info, const fs::path& dictionary, Log& log)
{
    const auto file = annotatedDictionary(info, dictionary);
    for (const auto& key : Dictionary::read(file, file.parent_path()).keyPaths()) log.line(key);
}

void writeDefaults(const ApplicationInfo& info,
                   const fs::path& folder,
                   const std::string& dictionary,
                   Log& log)
{
    std::error_code failure;
    const auto root = fs::canonical(folder, failure);
    if (failure || !fs::is_directory(root, failure))
        throw Error(ExitCode::commandLine, format("there is no folder '{}'", folder.string()));

    const auto target = confinedPath(root, dictionary);
    if (fs::exists(fs::symlink_status(target, failure)))
        throw Error(ExitCode::dictionary, format("{} exists already", target.string()),
                    "rename or delete it first; -listKeys shows the keys it may hold");

    if (info.proposal && dictionary == info.dictionary
        && fs::exists(root / "system/controlDict", failure)) {
        OutputFolder(root).write(dictionary, info.proposal(Case(root)));
        return log.line(format("written: {} (proposed for this case; {} -listKeys shows all "
                               "keywords)",
                               target.string(), info.name));
    }
    const auto source = annotatedDictionary(info, dictionary);
    std::ifstream stream(source, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw Error(ExitCode::fileIo, format("cannot read {}", source.string()));
    OutputFolder(root).write(dictionary, text.str());
    log.line(
        format("written: {} (every keyword there is; keep what the case needs)", target.string()));
}

/// Options that are answered without a case. False when there is a run to do.
bool answerQuestion(const ApplicationInfo& info, const OptionValues& options, Log& log)
{
    if (isGiven(options, "help"))
        log.line(helpText(info));
    else if (isGiven(options, "version"))
        log.line(format("{} {}", info.name, versionText()));
    else if (isGiven(options, "listKeys"))
        listKeys(info, valueOr(options, "dict", info.dictionary), log);
    else if (isGiven(options, "writeDefaults"))
        writeDefaults(info, valueOr(options, "case", "."),
                      valueOr(options, "dict", info.dictionary), log);
    else
        return false;
    return true;
}

/// log.<application>, the previous one kept as log.<application>.1. What cannot be moved away (in
/// a case that is read-only, say) is left alone, and the run is logged on the terminal only.
Log openLog(const Case& theCase, const ApplicationInfo& info)
{
    const std::string file = "log." + info.name;
    try {
        const OutputFolder output = theCase.output();
        std::error_code failure;
        if (fs::exists(fs::symlink_status(theCase.path(file), failure)))
            output.rename(file, file + ".1");
        return Log(output.open(file, O_WRONLY | O_CREAT | O_EXCL | O_APPEND).release());
    } catch (const Error&) {
        return Log();
    }
}

void logBanner(Run& run, int argc, char** argv)
{
    std::string command;
    for (int number = 0; number < argc; ++number)
        command.append(number == 0 ? "" : " ").append(argv[number]);
    auto& log = run.log;
    log.line(format("Build  : {}, compiler {}", versionText(), __VERSION__));
    log.line(format("Exec   : {}", command));
    log.line(format("Date   : {}", utcDate()));
    log.line(format("Host   : {}", hostName()));
    log.line(format("PID    : {}", processNumber()));
    if (!run.theCase.root().empty()) log.line(format("Case   : {}", run.theCase.root().string()));
    log.line();
}

/// Log readers of the field match these two lines to the blank.
void logEnd(Log& log, std::chrono::steady_clock::time_point start)
{
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    log.finish();
    log.line(format("ExecutionTime = {} s  ClockTime = {} s",
                    toText(std::round(10 * processorSeconds()) / 10),
                    std::llround(elapsed.count())));
    log.line();
    log.line("End");
}

ExitCode answerError(Log& log, const Error& error)
{
    auto text = std::string(error.what());
    if (!error.advice().empty()) text += "\n  = " + error.advice();
    if (error.code() == ExitCode::stopped)
        log.line(text);
    else
        log.error(text);
    return error.code();
}

/// Prints the exception being handled.
ExitCode answerException(Log& log)
{
    try {
        throw;
    } catch (const Error& error) {
        return answerError(log, error);
    } catch (const std::bad_alloc&) {
        log.error("out of memory\n  = a coarser mesh or fewer output fields need less");
        return ExitCode::memory;
    } catch (const fs::filesystem_error& error) {
        log.error(error.what());
        return ExitCode::fileIo;
    } catch (const std::exception& error) {
        log.error(format("internal error: {}\n  = this is a fault of the program", error.what()));
    } catch (...) {
        log.error("internal error of unknown kind\n  = this is a fault of the program");
    }
    return ExitCode::internal;
}

} // namespace

int runApplication(const ApplicationInfo& info,
                   int argc,
                   char** argv,
                   const std::function<void(Run&)>& body)
{
    protectStandardStreams();
    const auto start = std::chrono::steady_clock::now();
    Log terminal;
    std::optional<CaseLock> lock;
    std::optional<Run> run;
    try {
        auto options = parseCommandLine(info, argc, argv);
        if (answerQuestion(info, options, terminal)) return int(ExitCode::success);

        const bool caseless = !info.caseless.empty() && isGiven(options, info.caseless);
        const Case theCase = caseless ? Case::none() : Case(valueOr(options, "case", "."));
        if (info.locksCase && !caseless) {
            lock.emplace(theCase.root(), info.name);
            sweepTemporaries(theCase.root());
        }
        if (!isGiven(options, "dict") && !info.dictionary.empty())
            options.emplace_back("dict", info.dictionary);
        run.emplace(theCase, isGiven(options, "noLog") || caseless ? Log() : openLog(theCase, info),
                    options);

        logBanner(*run, argc, argv);
        body(*run);
        logEnd(run->log, start);
        return int(ExitCode::success);
    } catch (...) {
        auto& log = run ? run->log : terminal;
        log.finish();
        return int(answerException(log));
    }
}

} // namespace fpm
