#pragma once

#include "study/Continuation.h"
#include "study/RunTable.h"

#include <filesystem>
#include <limits>
#include <string>

namespace fpm {

/// The programs that make a run, in one folder.
class Pipeline
{
public:
    /// Throws Error(fileIo) where a program is missing.
    explicit Pipeline(std::filesystem::path binFolder);
    /// Those beside this program.
    static Pipeline beside();

    /// Checksum of the programs: another build is another speed, and maybe another result.
    const std::string& key() const { return key_; }

    /// fpmMesh, fpmSetContact and fpmExplicit, as far as `folder` has their dictionaries, then
    /// fpmProbe -tables if asked. A failing program ends the run and is its result, as is one that
    /// still runs `timeLimit` seconds after the first was started. A run that goes on keeps the
    /// mesh that is there, and what it took before is part of its times and of the limit. Throws
    /// Error for what is none: interruption (stopped), a full disk (fileIo), a case in use
    /// (caseLocked).
    RunRow run(const std::filesystem::path& folder,
               bool tables,
               double timeLimit = std::numeric_limits<double>::infinity(),
               const Continuation& from = {}) const;

private:
    std::filesystem::path bin_;
    std::string key_;
};

} // namespace fpm
