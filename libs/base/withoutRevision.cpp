// Apart from versionText, so that no program that is looked through holds the head as a word of its
// own.
#include "base/Revision.h"
#include "base/Version.h"

#include <algorithm>

namespace fpm {

std::string withoutRevision(std::string program)
{
    for (auto at = program.find(revisionHead); at != program.npos;
         at = program.find(revisionHead, at + 1)) {
        const auto first = at + revisionHead.size();
        const auto last = std::min(at + revisionBytes, program.size());
        std::fill(program.begin() + std::ptrdiff_t(first), program.begin() + std::ptrdiff_t(last),
                  '\0');
    }
    return program;
}

} // namespace fpm
