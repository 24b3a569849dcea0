#include "model/PartReader.h"

#include "model/MaterialReader.h"
#include "model/Names.h"

namespace fpm {

namespace {

PartKind readKind(const Lineage& lineage)
{
    const std::string word =
        holder(lineage, "model").choice("model", {"elastic", "elastoplastic", "rigid"});
    return word == "elastic"         ? PartKind::elastic
           : word == "elastoplastic" ? PartKind::elastoplastic
                                     : PartKind::rigid;
}

void readHourglass(const Lineage& lineage, Part& part)
{
    const Dictionary entry = holder(lineage, "hourglass").subOrEmpty("hourglass");
    const std::string form =
        entry.choiceOr("form", "stiffness", {"stiffness", "viscous", "physical"});
    // Beyond `largest` the hourglass modes, not the element, would limit the time step.
    double preset = 0.05, largest = 0.2;
    if (form == "viscous") {
        part.hourglass = HourglassForm::viscous;
        preset = 0.1;
    } else if (form == "physical") {
        part.hourglass = HourglassForm::physical;
        preset = largest = 1.0;
    }
    part.hourglassCoefficient = entry.numberOr("coefficient", preset, between(0, largest));
    const std::string plastic =
        entry.choiceOr("plastic", "coupled", {"elastic", "coupled", "tangent"});
    part.hourglassPlastic = plastic == "elastic"   ? HourglassPlastic::elastic
                            : plastic == "tangent" ? HourglassPlastic::tangent
                                                   : HourglassPlastic::coupled;
}

RotationForm readRotation(const Lineage& lineage)
{
    const std::string word =
        holder(lineage, "rotation")
            .choiceOr("rotation", "midSurface", {"midSurface", "arcsin", "polar", "hughesWinget"});
    return word == "arcsin"         ? RotationForm::arcsine
           : word == "polar"        ? RotationForm::polar
           : word == "hughesWinget" ? RotationForm::hughesWinget
                                    : RotationForm::midSurface;
}

Part readPart(const Dictionary& parts, const std::string& name)
{
    const Lineage lineage = lineageOf(parts, name);
    Part part;
    part.name = name;
    part.kind = readKind(lineage);
    if (part.kind == PartKind::rigid) {
        refuseFlow(lineage.front());
        part.density = holder(lineage, "density").numberOr("density", 0.0, nonNegative());
        part.youngsModulus =
            holder(lineage, "youngsModulus").numberOr("youngsModulus", 0.0, nonNegative());
        part.poissonsRatio =
            holder(lineage, "poissonsRatio").numberOr("poissonsRatio", 0.0, {-1, 0.5, true, true});
        return part;
    }
    part.density = number(lineage, "density", positive());
    part.youngsModulus = number(lineage, "youngsModulus", positive());
    part.poissonsRatio = number(lineage, "poissonsRatio", {-1, 0.5, true, true});
    if (part.kind == PartKind::elastoplastic)
        readFlow(lineage, part);
    else
        checkUnusedFlow(lineage, part); // elastic and plastic differ by one word
    readErosion(lineage, part);
    part.rotation = readRotation(lineage);
    readHourglass(lineage, part);
    const Dictionary viscosity = holder(lineage, "bulkViscosity").subOrEmpty("bulkViscosity");
    part.linearBulkViscosity = viscosity.numberOr("linear", 0.06, between(0, 1));
    part.quadraticBulkViscosity = viscosity.numberOr("quadratic", 1.2, between(0, 10));
    return part;
}

std::vector<std::string> partNames(const Mesh& mesh)
{
    std::vector<std::string> names;
    for (const MeshPart& part : mesh.parts) names.push_back(part.name);
    return names;
}

} // namespace

std::vector<Part> readParts(const Dictionary& dictionary, const Mesh& mesh)
{
    const Dictionary entries = dictionary.sub("parts");
    const std::vector<std::string> names = partNames(mesh);
    for (const std::string& name : entries.keys())
        if (mesh.findPart(name) < 0)
            entries.fail(name, "the mesh has no part '" + name + "'",
                         nameAdvice(name, names, "parts of the mesh"));

    std::vector<Part> parts;
    for (const std::string& name : names) {
        if (!entries.has(name))
            dictionary.fail("parts", "part '" + name + "' of the mesh has no entry",
                            "add its properties, or 'like' another part: " + name + " { like "
                                + (entries.keys().empty() ? "<part>" : entries.keys().front())
                                + "; }");
        parts.push_back(readPart(entries, name));
    }
    dictionary.requireAllUsed();
    return parts;
}

std::vector<bool> readRigidParts(const Dictionary& dictionary, const Mesh& mesh)
{
    const Dictionary entries = dictionary.sub("parts");
    std::vector<bool> rigid;
    for (const MeshPart& part : mesh.parts)
        rigid.push_back(entries.has(part.name)
                        && readKind(lineageOf(entries, part.name)) == PartKind::rigid);
    return rigid;
}

} // namespace fpm
