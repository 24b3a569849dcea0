#include "model/readModel.h"

#include "base/Format.h"
#include "case/UnreadFiles.h"
#include "mesh/MeshFile.h"
#include "model/BoundaryReader.h"
#include "model/CaseReader.h"
#include "model/ContactReader.h"
#include "model/ContactSetup.h"
#include "model/ControlReader.h"
#include "model/GeneralContact.h"
#include "model/InitialDepth.h"
#include "model/MotionCheck.h"
#include "model/PaperAlgorithm.h"
#include "model/PartMaterial.h"
#include "model/PartReader.h"
#include "model/RigidContact.h"
#include "model/SurfaceReport.h"

#include <set>

namespace fpm {

namespace {

/// A case without boundary or initial conditions is complete: bodies start at rest and are free.
Dictionary dictionaryOrEmpty(const Case& theCase, const std::string& relative)
{
    return theCase.hasFile(relative) ? theCase.dictionary(relative)
                                     : Dictionary::parse("", relative);
}

const ContactSurfaces& surfacesOf(const Mesh& mesh, const std::string& pair)
{
    for (const ContactSurfaces& surfaces : mesh.contact)
        if (surfaces.pair == pair) return surfaces;
    throw Error(ExitCode::mesh,
                "constant/mesh.vtkhdf has no contact surfaces for pair '" + pair + "'",
                "run fpmSetContact");
}

ContactPair makePair(const PairEntry& entry, const ContactSurfaces& surfaces)
{
    ContactPair pair{};
    static_cast<ContactLaw&>(pair) = entry;
    pair.name = entry.name;
    pair.contactorNodes = surfaces.contactorNodes;
    pair.targetSides = surfaces.targetSides;
    pair.search = entry.search;
    pair.projection = entry.projection;
    pair.kind =
        surfaces.contactorSides == surfaces.targetSides ? ContactKind::self : ContactKind::pair;
    pair.passes = entry.passes;
    pair.edges = entry.edges;
    pair.initialOverlap = entry.initialOverlap;
    pair.rampTime = entry.rampTime;
    return pair;
}

/// Surfaces from the mesh file, numbers from contactDict.
void readContact(const Case& theCase, Model& model, Log& log)
{
    if (!theCase.hasFile("system/contactDict")) {
        if (!model.mesh.contact.empty())
            log.line("no system/contactDict: the contact surfaces of the mesh are not used");
        return;
    }
    if (contactIsOutdated(model.mesh, theCase))
        throw Error(ExitCode::mesh,
                    "the contact surfaces in constant/mesh.vtkhdf were not made from this "
                    "system/contactDict and this mesh",
                    "run fpmSetContact");

    std::vector<bool> rigid;
    for (const Part& part : model.parts) rigid.push_back(isRigid(part.kind));
    const Dictionary contactDict = theCase.dictionary("system/contactDict");
    const ContactEntries entries = readContactEntries(contactDict);
    model.rigidSurfaces = entries.rigidSurfaces;
    for (const PairEntry& entry : entries.pairs) {
        const ContactSurfaces& surfaces = surfacesOf(model.mesh, entry.name);
        const Dictionary place = contactDict.sub("pairs").sub(entry.name);
        ContactPair pair = makePair(entry, surfaces);
        pair.surface = entries.rigidSurface(entry.target);
        if (pair.surface >= 0) {
            pair.kind = ContactKind::pair;
            refuseRigidContactor(model.mesh, surfaces, rigid, place);
            refuseSurfaceOverlap(model.mesh, surfaces,
                                 model.rigidSurfaces[std::size_t(pair.surface)], place);
        } else {
            refuseRigidPair(model.mesh, surfaces, rigid, place);
            refuseDeepStart(model.mesh, surfaces, entry.passes, place);
        }
        model.contactPairs.push_back(std::move(pair));
    }
    if (entries.general) {
        ContactPair general = makePair(*entries.general, surfacesOf(model.mesh, generalContact));
        general.kind = ContactKind::general;
        std::vector<ContactSurfaces> pairs;
        for (const PairEntry& entry : entries.pairs) {
            pairs.push_back(surfacesOf(model.mesh, entry.name));
            const auto parts = meetingsOf(model.mesh, pairs.back());
            general.apart.insert(general.apart.end(), parts.begin(), parts.end());
        }
        refuseDeepBodies(model.mesh, rigid, pairs, contactDict);
        model.contactPairs.push_back(std::move(general));
    }
}

/// Rigid bodies limit no step; without an element to do so the step must be given.
void requireStep(const Model& model, const Dictionary& control)
{
    bool deformable = false, free = false;
    for (const Part& part : model.parts) {
        deformable |= !isRigid(part.kind);
        free |= part.kind == PartKind::rigidFree;
    }
    if (free && !deformable && !(model.control.fixedTimeStep > 0))
        control.fail("timeStep", "all parts are rigid: nothing limits the time step",
                     "give it, such as: timeStep { fixed 1e-5; }");
}

void report(const Model& model, Log& log)
{
    if (!model.title.empty()) log.line(model.title);
    log.line(format("{} elements, {} nodes, {} parts; units {} {} {}", model.mesh.hexahedra.size(),
                    model.mesh.points.size(), model.parts.size(), model.units[0], model.units[1],
                    model.units[2]));
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        const Part& part = model.parts[i];
        std::string line = format("part {}: {}, {} elements", part.name, wordOf(part.kind),
                                  model.mesh.parts[i].elementCount);
        if (!isRigid(part.kind))
            line +=
                format(", wave speed {} {}/{}", waveSpeed(part), model.units[0], model.units[2]);
        log.line(line);
    }
    log.line(format("{} boundary conditions, {} initial velocities, {} contact pairs",
                    model.boundaryConditions.size(), model.initialVelocities.size(),
                    model.contactPairs.size()));
}

} // namespace

Model readModel(const Case& theCase, Log& log)
{
    return readModel(theCase, theCase.dictionary("system/controlDict"), log);
}

Model readModel(const Case& theCase, const Dictionary& control, Log& log)
{
    warnOfUnreadFiles(theCase, control.name(), log);
    Model model;
    const CaseProperties properties =
        readCaseProperties(theCase.dictionary("constant/caseProperties"));
    model.title = properties.title;
    model.units = properties.units;
    model.mesh = readMesh(theCase.path(meshFile));
    model.parts = readParts(theCase.dictionary("constant/partProperties"), model.mesh);
    checkUnits(model.parts, model.units, log);

    const Dictionary boundary = dictionaryOrEmpty(theCase, "constant/boundaryConditions");
    model.boundaryConditions = readBoundaryConditions(boundary, model.mesh);
    checkGravity(model.boundaryConditions, model.units, log);
    model.initialVelocities =
        readInitialVelocities(dictionaryOrEmpty(theCase, "0/initialConditions"), model.mesh);
    checkMotions(model, boundary, log);

    model.control = readControl(control, log);
    requireStep(model, control);
    readMassScaling(control, model.parts);
    readContact(theCase, model, log);
    if (model.control.paperAlgorithm)
        applyPaperAlgorithm(model, control, theCase.dictionary("constant/partProperties"),
                            dictionaryOrEmpty(theCase, "system/contactDict"), log);
    model.control.histories = readHistories(control, model, log);
    control.requireAllUsed();
    report(model, log);
    return model;
}

} // namespace fpm
