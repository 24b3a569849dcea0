#include "model/ContactSetup.h"

#include "base/Format.h"
#include "mesh/MeshFile.h"
#include "mesh/Surface.h"
#include "model/ContactReader.h"
#include "model/ContactReport.h"
#include "model/ContactSurface.h"
#include "model/PartReader.h"
#include "model/PointAlgebra.h"
#include "model/RigidContact.h"
#include "model/SurfaceReport.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace fpm {

namespace {

/// FNV-1a, 64 bit: two surfaces' texts are told apart, nothing is defended.
std::string fingerprint(std::string_view text)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char letter : text) {
        hash ^= static_cast<unsigned char>(letter);
        hash *= 0x100000001b3U;
    }
    char digits[16];
    const auto end = std::to_chars(digits, digits + sizeof digits, hash, 16).ptr;
    const std::string number(digits, end);
    return std::string(16 - number.size(), '0') + number;
}

std::string keyOf(const ContactEntries& entries, const Mesh& mesh)
{
    return fingerprint(surfaceText(entries) + meshChecksum(mesh));
}

/// A node on its own target face would always find itself, with gap 0.
void refuseOwnTargets(const Mesh& mesh, const ContactSurfaces& surfaces, const Dictionary& pair)
{
    const std::vector<Index> targetNodes = nodesOf(mesh, surfaces.targetSides);
    std::vector<Index> both;
    std::set_intersection(surfaces.contactorNodes.begin(), surfaces.contactorNodes.end(),
                          targetNodes.begin(), targetNodes.end(), std::back_inserter(both));
    if (both.empty()) return;
    pair.fail(
        "target",
        format("{} nodes are contactor and target at once, first node {} at {}", both.size(),
               both.front(), pointText(mesh.points[std::size_t(both.front())])),
        "give the two sides of the pair to bodies, or surfaces of a body, that share no nodes");
}

} // namespace

void setContact(Mesh& mesh, const Dictionary& contactDict, const Case& theCase, Log& log)
{
    const ContactEntries entries = readContactEntries(contactDict);
    std::vector<bool> rigid(mesh.parts.size(), false);
    if (theCase.hasFile("constant/partProperties"))
        rigid = readRigidParts(theCase.dictionary("constant/partProperties"), mesh);

    std::vector<ContactSurfaces> pairs;
    for (const PairEntry& entry : entries.pairs) {
        ContactSurfaces surfaces;
        surfaces.pair = entry.name;
        surfaces.contactorSides = contactSides(mesh, entries, entry, "contactor", contactDict);
        const Dictionary place = contactDict.sub("pairs").sub(entry.name);
        surfaces.contactorNodes = nodesOf(mesh, surfaces.contactorSides);
        if (const Index surface = entries.rigidSurface(entry.target); surface >= 0) {
            refuseRigidContactor(mesh, surfaces, rigid, place);
            reportSurfaceContact(mesh, surfaces, entries.rigidSurfaces[std::size_t(surface)], log);
            pairs.push_back(std::move(surfaces));
            continue;
        }
        surfaces.targetSides = contactSides(mesh, entries, entry, "target", contactDict);
        refuseRigidPair(mesh, surfaces, rigid, place);
        refuseOwnTargets(mesh, surfaces, place);
        reportContact(mesh, surfaces, measureContact(mesh, surfaces), log);
        pairs.push_back(std::move(surfaces));
    }
    if (pairs.empty())
        log.warning(contactDict.name() + " has no pairs: the bodies pass through each other");
    reportSharing(pairs, log);
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
    const auto file = theCase.path("constant/mesh.vtkhdf");
    Mesh mesh = readMesh(file);
    if (!contactIsOutdated(mesh, theCase)) return;
    log.line("contact surfaces are missing or out of date: doing the work of fpmSetContact first");
    setContact(mesh, theCase.dictionary("system/contactDict"), theCase, log);
    writeMesh(file, mesh);
}

} // namespace fpm
