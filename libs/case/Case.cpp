#include "case/Case.h"

#include "base/Format.h"
#include "base/ReadObstacle.h"
#include "case/Confinement.h"
#include "case/UnreadFiles.h"

#include <system_error>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// What lies behind a closed folder is not missing.
void requireReachable(const fs::path& path)
{
    std::error_code failure;
    if (fs::exists(path, failure) || failure != std::errc::permission_denied) return;
    const auto [reason, advice] = readObstacle(path, failure.value());
    throw Error(ExitCode::fileIo, format("cannot read {}: {}", path.string(), reason), advice);
}

} // namespace

Case::Case(fs::path root)
{
    std::error_code failure;
    root_ = fs::canonical(root, failure);
    requireReachable(root);
    if (failure || !fs::is_directory(root_, failure))
        throw Error(ExitCode::commandLine, format("there is no case folder '{}'", root.string()));
    requireReachable(root_ / "system/controlDict");
    if (!hasFile("system/controlDict") && !hasFile("system/meshDict"))
        throw Error(ExitCode::commandLine, format("'{}' is not a case", root_.string()),
                    "a case has system/controlDict or system/meshDict; name it with -case <dir>");
}

Dictionary Case::dictionary(std::string_view relative) const
{
    requireReachable(path(relative));
    if (!hasFile(relative)) {
        const std::string meant = lookalikeOf(*this, std::string(relative));
        throw Error(ExitCode::dictionary,
                    format("{} is missing in case {}", relative, root_.string()),
                    meant.empty()
                        ? "copy it from a tutorial, or let the application write it: -writeDefaults"
                        : format("is '{}' meant for it? Rename it", meant));
    }
    return Dictionary::read(path(relative), root_);
}

bool Case::hasFile(std::string_view relative) const
{
    std::error_code failure;
    return fs::exists(path(relative), failure);
}

fs::path Case::inside(std::string_view relative) const
{
    return confinedPath(root_, relative);
}

} // namespace fpm
