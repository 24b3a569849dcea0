#include "model/PaperAlgorithm.h"

#include "base/Format.h"
#include "model/Lineage.h"

namespace fpm {

namespace {

void checkParts(const Model& model,
                const Dictionary& control,
                const Dictionary& parts,
                std::vector<std::string>& overridden)
{
    const Dictionary entries = parts.sub("parts");
    for (const Part& part : model.parts) {
        if (isRigid(part.kind)) continue;
        if (part.hexahedron == HexahedronForm::selective)
            control.fail("algorithm",
                         "part '" + part.name
                             + "' has hexahedron selective; the paper's element has one point",
                         "give the part hexahedron reduced, or write: algorithm default;");
        const Lineage lineage = lineageOf(entries, part.name);
        if (holder(lineage, "rotation").has("rotation") && part.rotation != RotationForm::arcsine)
            overridden.push_back("rotation of part " + part.name);
    }
}

void checkPairs(const Model& model,
                const Dictionary& control,
                const Dictionary& contact,
                std::vector<std::string>& overridden)
{
    for (const ContactPair& pair : model.contactPairs) {
        if (pair.surface >= 0) continue; // exact, nothing to search
        if (pair.kind != ContactKind::pair)
            control.fail("algorithm",
                         "'" + pair.name
                             + "' is contact of surfaces with themselves, which the paper's search "
                               "cannot do: the closest particle of a node is its own neighbour",
                         "give the bodies pairs, or write: algorithm default;");
        const Dictionary entry = contact.sub("pairs").sub(pair.name);
        const auto note = [&](const char* key, bool differs) {
            if (differs && entry.has(key))
                overridden.push_back(std::string(key) + " of pair " + pair.name);
        };
        note("search", pair.search != ContactSearch::closestParticle);
        note("projection", pair.projection != ContactProjection::cold);
        if (pair.friction > 0 && entry.isDictionary("friction") && !pair.paperFriction)
            overridden.push_back("friction form of pair " + pair.name);
    }
}

} // namespace

void takePaperForms(Model& model)
{
    model.control.midStepStrain = false;
    for (Part& part : model.parts)
        if (!isRigid(part.kind)) part.rotation = RotationForm::arcsine;
    for (ContactPair& pair : model.contactPairs) {
        if (pair.surface >= 0) continue; // exact, nothing to search
        pair.search = ContactSearch::closestParticle;
        pair.projection = ContactProjection::cold;
        if (pair.friction > 0) pair.paperFriction = true;
    }
}

void applyPaperAlgorithm(Model& model,
                         const Dictionary& control,
                         const Dictionary& parts,
                         const Dictionary& contact,
                         Log& log)
{
    std::vector<std::string> overridden;
    if (control.has("strainGeometry") && model.control.midStepStrain)
        overridden.push_back("strainGeometry");
    checkParts(model, control, parts, overridden);
    checkPairs(model, control, contact, overridden);
    takePaperForms(model);
    // The print has no damping; what a case asks for it gets.
    for (ContactPair& pair : model.contactPairs)
        if (pair.paperFriction && !contact.sub("pairs").sub(pair.name).has("normalDamping"))
            pair.normalDamping = 0;
    for (const std::string& entry : overridden) log.warning("algorithm paper overrides " + entry);
    log.line(
        "algorithm of the paper, for comparison: rotation arcsin, strainGeometry start, search "
        "closestParticle, projection cold, friction form paper");
}

} // namespace fpm
