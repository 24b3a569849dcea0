#include "model/ContactSetup.h"

#include "base/Format.h"
#include "base/Hash.h"
#include "mesh/MeshFile.h"
#include "mesh/Quality.h"
#include "mesh/SharpEdges.h"
#include "mesh/Surface.h"
#include "model/ContactReader.h"
#include "model/ContactReport.h"
#include "model/ContactSurface.h"
#include "model/EdgeCrossing.h"
#include "model/GeneralContact.h"
#include "model/PartReader.h"
#include "model/PointAlgebra.h"
#include "model/RigidContact.h"
#include "model/SurfaceReport.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace fpm {

namespace {

std::string keyOf(const ContactEntries& entries, const Mesh& mesh)
{
    return hexText(hashOf(surfaceText(entries) + meshChecksum(mesh)));
}

/// A node on its own target face would always find itself, with gap 0; a surface against itself
/// leaves the surroundings of each node out.
void refuseOwnTargets(const Mesh& mesh,
                      const ContactSurfaces& surfaces,
                      const PairEntry& entry,
                      const Dictionary& pair)
{
    if (surfaces.contactorSides == surfaces.targetSides) {
        if (entry.search == ContactSearch::closestParticle)
            pair.fail("search", "a surface in contact with itself needs the search by faces",
                      "the closest particle of a node would be its own neighbour");
        if (entry.passes == 2)
            pair.fail("passes", "a surface in contact with itself has one pass: every node is "
                                "contactor and target already");
        if (entry.initialOverlap == InitialOverlap::move)
            pair.fail("initialOverlap",
                      "in contact of a surface with itself nothing says which side should move",
                      "move the nodes in the mesh, or use offset or ramp");
        return;
    }
    const std::vector<Index> targetNodes = nodesOf(mesh, surfaces.targetSides);
    std::vector<Index> both;
    std::set_intersection(surfaces.contactorNodes.begin(), surfaces.contactorNodes.end(),
                          targetNodes.begin(), targetNodes.end(), std::back_inserter(both));
    if (both.empty()) return;
    pair.fail(
        "target",
        format("{} nodes are contactor and target at once, first node {} at {}", both.size(),
               both.front(), pointText(mesh.points[std::size_t(both.front())])),
        "give the two sides of the pair to bodies, or surfaces of a body, that share no nodes; or "
        "the same surface to both, for contact with itself");
}

/// Every contactor lies behind the target: the wrong side of it was chosen.
void refuseTargetsTurnedAway(const ContactFit& fit, const Dictionary& pair)
{
    if (fit.facesPointingAway == 0 || fit.facingNodes > 0 || !fit.depths.none()) return;
    pair.fail("target",
              format("all contactor nodes lie behind the target, {} of its faces point away from "
                     "the nodes nearest to them: it would draw them in",
                     fit.facesPointingAway),
              "choose the side that faces the contactor with a side set or 'facing'");
}

/// Moves the contactors that overlap to the target's surface; refuses where that would turn an
/// element inside out.
void moveToSurface(Mesh& mesh, const ContactFit& fit, const Dictionary& pair, Log& log)
{
    double farthest = 0;
    std::set<Index> moved;
    for (const auto* nodes : {&fit.depths.held, &fit.depths.tooDeep})
        for (const InitialDepths::Node& inside : *nodes) {
            Point& point = mesh.points[std::size_t(inside.node)];
            farthest = std::max(farthest, length(difference(inside.surface, point)));
            point = inside.surface;
            moved.insert(inside.node);
        }
    if (moved.empty()) return;
    for (std::size_t element = 0; element < mesh.hexahedra.size(); ++element) {
        const Hexahedron& nodes = mesh.hexahedra[element];
        if (std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return moved.count(n) > 0; })
            && !(volume(mesh, Index(element)) > 0))
            pair.fail(
                "initialOverlap",
                format("moving the contactors to the surface turns element {} inside out", element),
                "the overlap is deeper than the element is thick: move the bodies apart");
    }
    log.line(format("    {} nodes moved, by at most {}", moved.size(), farthest));
}

void reportCrossings(const Mesh& mesh, const ContactSurfaces& surfaces, bool edges, Log& log)
{
    const EdgeCrossings found =
        edgeCrossings(mesh, mesh.points, surfaces.contactorSides, surfaces.targetSides);
    if (found.count > 0)
        log.warning(format("pair {}: {} edges pass through the other surface between their nodes, "
                           "deepest at {}: {}",
                           surfaces.pair, found.count, pointText(found.place),
                           edges ? "contact of edges treats them as initialOverlap says"
                                 : "node-to-face contact does not see them, 'edges yes;' would"));
}

/// How many segments of sharp edges meet those of the other surface.
void reportEdges(const Mesh& mesh, const ContactSurfaces& surfaces, Log& log)
{
    const std::size_t own = sharpEdges(mesh, surfaces.contactorSides).size();
    if (surfaces.contactorSides == surfaces.targetSides)
        log.line(format("    {} segments of sharp edges", own));
    else
        log.line(format("    {} segments of sharp edges against {}", own,
                        sharpEdges(mesh, surfaces.targetSides).size()));
}

/// What needs faces has no meaning against an analytic surface.
void refuseFaceOptions(const PairEntry& entry, const Dictionary& place)
{
    const std::string instead =
        "remove the entry: the target is an analytic surface, without faces";
    if (entry.search == ContactSearch::closestParticle)
        place.fail("search", "the target has no particles to search", instead);
    if (entry.projection == ContactProjection::cold)
        place.fail("projection", "the target has no faces to project on", instead);
    if (entry.edges) place.fail("edges", "the target has no edges", instead);
    if (entry.passes == 2)
        place.fail("passes", "the target has no nodes for a second pass", instead);
    if (place.has("initialOverlap") && entry.initialOverlap != InitialOverlap::report)
        place.fail("initialOverlap", "only overlaps with faces can be forgiven or moved", instead);
}

ContactSurfaces setPair(Mesh& mesh,
                        const ContactEntries& entries,
                        const PairEntry& entry,
                        const std::vector<bool>& rigid,
                        const Dictionary& contactDict,
                        Log& log)
{
    ContactSurfaces surfaces;
    surfaces.pair = entry.name;
    surfaces.contactorSides = contactSides(mesh, entries, entry, "contactor", contactDict);
    surfaces.contactorNodes = nodesOf(mesh, surfaces.contactorSides);
    const Dictionary place = contactDict.sub("pairs").sub(entry.name);
    if (const Index surface = entries.rigidSurface(entry.target); surface >= 0) {
        refuseRigidContactor(mesh, surfaces, rigid, place);
        refuseFaceOptions(entry, place);
        reportSurfaceContact(mesh, surfaces, entries.rigidSurfaces[std::size_t(surface)], log);
        refuseSurfaceOverlap(mesh, surfaces, entries.rigidSurfaces[std::size_t(surface)], place);
        return surfaces;
    }
    surfaces.targetSides = contactSides(mesh, entries, entry, "target", contactDict);
    refuseRigidPair(mesh, surfaces, rigid, place);
    refuseOwnTargets(mesh, surfaces, entry, place);
    reportSeams(mesh, surfaces, log);
    if (surfaces.contactorSides == surfaces.targetSides) {
        log.line(format("pair {}: {} nodes in contact with {} faces of their own surface",
                        surfaces.pair, surfaces.contactorNodes.size(),
                        surfaces.targetSides.size()));
        if (entry.edges) reportEdges(mesh, surfaces, log);
        return surfaces;
    }
    const ContactFit fit = measureContact(mesh, surfaces);
    refuseTargetsTurnedAway(fit, place);
    reportContact(mesh, surfaces, fit, entry.initialOverlap, entry.passes, log);
    if (entry.initialOverlap == InitialOverlap::move) moveToSurface(mesh, fit, place, log);
    refuseDeepStart(mesh, surfaces, entry.passes, place);
    if (entry.edges) reportEdges(mesh, surfaces, log);
    reportCrossings(mesh, surfaces, entry.edges, log);
    return surfaces;
}

/// All exterior faces of all parts; overlaps are searched between parts whose boxes intersect.
ContactSurfaces setGeneral(const Mesh& mesh,
                           const PairEntry& entry,
                           const std::vector<bool>& rigid,
                           const std::vector<ContactSurfaces>& pairs,
                           const Dictionary& contactDict,
                           Log& log)
{
    const ContactSurfaces surfaces = allSurfaces(mesh, entry.name);
    log.line(format("general contact: {} nodes, {} faces of {} parts",
                    surfaces.contactorNodes.size(), surfaces.targetSides.size(),
                    mesh.parts.size()));
    if (entry.edges) reportEdges(mesh, surfaces, log);
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) // nodes of two bodies may meet
        reportSeams(
            mesh, {entry.name + ", part " + mesh.parts[part].name, {}, {}, skin(mesh, Index(part))},
            log);
    for (const ContactSurfaces& two : meetingBodies(mesh, rigid, {})) {
        reportOverlaps(mesh, two.pair, measureContact(mesh, two), entry.initialOverlap, log);
        if (two.contactorSides < two.targetSides) reportCrossings(mesh, two, entry.edges, log);
    }
    refuseDeepBodies(mesh, rigid, pairs, contactDict);
    return surfaces;
}

} // namespace

void setContact(Mesh& mesh, const Dictionary& contactDict, const Case& theCase, Log& log)
{
    std::vector<bool> rigid(mesh.parts.size(), false);
    if (theCase.hasFile("constant/partProperties"))
        rigid = readRigidParts(theCase.dictionary("constant/partProperties"), mesh);
    setContact(mesh, contactDict, rigid, log);
}

void setContact(Mesh& mesh, const Dictionary& contactDict, const std::vector<bool>& rigid, Log& log)
{
    const ContactEntries entries = readContactEntries(contactDict);
    std::vector<ContactSurfaces> pairs;
    for (const PairEntry& entry : entries.pairs)
        pairs.push_back(setPair(mesh, entries, entry, rigid, contactDict, log));
    reportSharing(pairs, log);
    if (entries.general)
        pairs.push_back(setGeneral(mesh, *entries.general, rigid, pairs, contactDict, log));
    if (pairs.empty())
        log.warning(contactDict.name() + " has no pairs: the bodies pass through each other");
    mesh.contact = std::move(pairs);
    mesh.contactKey = keyOf(entries, mesh);
}

bool contactIsOutdated(const Mesh& mesh, const Case& theCase)
{
    if (!theCase.hasFile("system/contactDict")) return false;
    const ContactEntries entries = readContactEntries(theCase.dictionary("system/contactDict"));
    return mesh.contactKey != keyOf(entries, mesh);
}

void updateContact(const Case& theCase, Log& log)
{
    Mesh mesh = readMesh(theCase.path(meshFile));
    if (!contactIsOutdated(mesh, theCase)) return;
    log.line("contact surfaces are missing or out of date: doing the work of fpmSetContact first");
    setContact(mesh, theCase.dictionary("system/contactDict"), theCase, log);
    writeMesh(theCase.output(), mesh);
}

} // namespace fpm
