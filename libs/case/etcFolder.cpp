#include "base/Format.h"
#include "case/Case.h"

#include <system_error>

namespace fpm {

namespace fs = std::filesystem;

fs::path etcFolder()
{
    std::error_code failure;
    const auto bin = fs::read_symlink("/proc/self/exe", failure).parent_path();
    // Beside bin/ in the sources, above a build folder in the sources, or installed.
    for (const auto* place : {"../etc", "../../etc", "../share/fpm/etc"}) {
        const auto folder = (bin / place).lexically_normal();
        if (fs::is_directory(folder / "caseDicts", failure)) return folder;
    }
    throw Error(ExitCode::fileIo, format("no folder etc/caseDicts belongs to {}", bin.string()),
                "keep bin/ beside etc/, or install the programs with their share/fpm/etc");
}

} // namespace fpm
