#pragma once

#include "case/Case.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fpm {

struct Option {
    std::string name;        ///< without dash
    std::string value;       ///< "<n>", "<dir>"; empty for a switch
    std::string description; ///< one line
};

struct ApplicationInfo {
    std::string name;            ///< fpmMesh
    std::string purpose;         ///< one sentence for -help
    std::string dictionary;      ///< default of -dict: "system/meshDict"; may be empty
    std::vector<Option> options; ///< beyond the common ones
    bool locksCase = false;      ///< takes the case lock before any file is touched (writers do)
    std::string caseless = "";   ///< the option with which it needs no case, if there is one
    /// -writeDefaults: its dictionary made for a case; the annotated one where there is none.
    std::function<std::string(const Case&)> proposal = nullptr;
};

/// What an application works with: its case, its options, its log.
class Run
{
public:
    Run(Case itsCase, Log itsLog, std::vector<std::pair<std::string, std::string>> options)
        : theCase(std::move(itsCase)),
          log(std::move(itsLog)),
          options_(std::move(options))
    {
    }
    Case theCase;
    Log log;

    bool has(std::string_view option) const;
    std::optional<std::string> value(std::string_view option) const;
    /// A word option out of `allowed`; throws Error(commandLine) with the list.
    std::optional<std::string> choice(std::string_view option,
                                      const std::vector<std::string>& allowed) const;
    /// An integer option with limits; throws Error(commandLine).
    std::optional<std::int64_t>
    integer(std::string_view option, std::int64_t lower, std::int64_t upper) const;
    /// The dictionary of -dict, else the application's default.
    Dictionary dictionary() const;

private:
    std::vector<std::pair<std::string, std::string>> options_;
};

/// Common options (-case -dict -help -version -listKeys -writeDefaults -noLog), banner, log file,
/// case lock, one try/catch, exit code. `body` does the work; `End` is logged when it returns.
int runApplication(const ApplicationInfo& info,
                   int argc,
                   char** argv,
                   const std::function<void(Run&)>& body);

} // namespace fpm
