#include "mesher/Mesher.h"

#include "mesh/Patches.h"
#include "mesher/Bodies.h"
#include "mesher/MeshReport.h"
#include "mesher/Sets.h"

namespace fpm {

Mesh makeMesh(const Dictionary& meshDict, const Case& theCase, bool allowGeo, Log& log)
{
    // Everything is read before anything is meshed: a typo in the last set must not cost minutes.
    const Dictionary entries = meshDict.sub("bodies");
    const int refinement = int(meshDict.integerOr("refinement", 1, 1, 1000));
    const Bodies bodies = Bodies::read(entries, refinement);
    if (bodies.entries.empty()) meshDict.fail("bodies", "'bodies' must hold at least one body");
    const auto sets = readSets(meshDict.subOrEmpty("sets"));
    meshDict.requireAllUsed();

    MeshedBodies meshed = meshBodies(bodies, theCase, allowGeo, log);
    makeSets(sets, meshed, log);
    renumber(meshed.mesh);
    reportInnerSides(meshed.mesh, log);
    reportSmallElements(meshed.mesh, log);
    return std::move(meshed.mesh);
}

} // namespace fpm
