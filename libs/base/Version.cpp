#include "base/Version.h"

#include "base/Revision.h"

namespace fpm {

std::string versionText()
{
    const std::string_view revision = std::string_view(revisionRecord).substr(revisionHead.size());
    return std::string(FPM_VERSION) + (revision.empty() ? "" : " (" + std::string(revision) + ")");
}

} // namespace fpm
