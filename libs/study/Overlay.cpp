#include "study/Overlay.h"

#include "base/Format.h"
#include "case/Confinement.h"

namespace fpm {

namespace fs = std::filesystem;

void requireOverlay(const Dictionary& entry, const std::string& folder, const Case& theCase)
{
    if (!fs::is_directory(theCase.inside(folder)))
        entry.fail("overlay", format("the case has no folder '{}'", folder),
                   "none is the case as it is");
    // Copies are made there while the folder is read.
    const fs::path copies = fs::weakly_canonical(theCase.path("postProcessing/chart"));
    const fs::path overlay = fs::canonical(theCase.inside(folder));
    if (isBeneath(copies, overlay) || isBeneath(overlay, copies))
        entry.fail("overlay",
                   format("'{}' cannot be laid over copies of the case: they lie in it, in "
                          "postProcessing/chart",
                          folder),
                   "name a folder that holds the files to be laid over, and nothing else");
}

} // namespace fpm
