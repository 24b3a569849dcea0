#include "case/Confinement.h"

#include "base/Error.h"
#include "base/Format.h"

#include <algorithm>
#include <system_error>

namespace fpm {

namespace fs = std::filesystem;

fs::path confinedPath(const fs::path& root, std::string_view relative)
{
    const auto refuse = [&](std::string_view reason) {
        throw Error(ExitCode::fileIo, format("path '{}' {}", relative, reason),
                    "paths in a case are relative to it and stay inside");
    };
    if (relative.empty()) refuse("is empty");
    if (fs::path(relative).is_absolute()) refuse("is absolute");

    auto path = root;
    for (const auto& part : fs::path(relative)) {
        if (part == "..") refuse("leads upwards");
        path /= part;
        std::error_code failure;
        if (!fs::is_symlink(fs::symlink_status(path, failure))) continue;
        const auto target = fs::canonical(path, failure);
        if (failure || !isBeneath(target, root))
            refuse(format("passes the link '{}', which leads out of the case", path.string()));
    }
    return path;
}

bool isBeneath(const fs::path& path, const fs::path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first
           == folder.end();
}

} // namespace fpm
