#include "model/PartReader.h"

#include "base/Format.h"
#include "model/MaterialReader.h"
#include "model/Names.h"
#include "model/PartMaterial.h"

namespace fpm {

namespace {

PartKind readKind(const Lineage& lineage)
{
    return kindNamed(holder(lineage, "model").choice("model", kindWords()));
}

void readHourglass(const Lineage& lineage, Part& part)
{
    const Dictionary entry = holder(lineage, "hourglass").subOrEmpty("hourglass");
    std::vector<std::string> words;
    HourglassForms::visitAll([&]<class Form>() { words.push_back(Form::word); });
    const std::string word = entry.choiceOr("form", PhysicalHourglass::word, words);
    HourglassForms::visitAll([&]<class Form>() {
        if (word != Form::word) return;
        part.hourglass = HourglassForm(HourglassForms::indexOf<Form>());
        // Beyond the largest the hourglass modes, not the element, would limit the time step.
        part.hourglassCoefficient = entry.numberOr("coefficient", Form::presetCoefficient,
                                                   between(0, Form::largestCoefficient));
    });
    if (entry.choiceOr("plastic", "coupled", {"elastic", "coupled"}) == "elastic")
        part.hourglassPlastic = HourglassPlastic::elastic;
    if (entry.choiceOr("storage", "full", {"full", "float"}) == "float")
        part.hourglassStorage = HourglassStorage::float_;
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

/// `hexahedron` and `rotation`: the selective element has one rotation only.
void readElement(const Lineage& lineage, Part& part)
{
    part.rotation = readRotation(lineage);
    const std::string reduced = ReducedHexahedron<PhysicalHourglass>::word;
    if (holder(lineage, "hexahedron")
            .choiceOr("hexahedron", reduced, {reduced, SelectiveHexahedron::word})
        == reduced)
        return;
    part.hexahedron = HexahedronForm::selective;
    const Dictionary& entry = holder(lineage, "rotation");
    if (entry.has("rotation") && part.rotation != RotationForm::hughesWinget)
        entry.fail("rotation", "hexahedron selective turns every integration point by its spin",
                   "write: rotation hughesWinget; or remove the entry");
    part.rotation = RotationForm::hughesWinget;
    if (part.erosion.any())
        holder(lineage, "erosion")
            .fail("erosion", "elements of hexahedron selective are never deleted",
                  "use hexahedron reduced, or remove the entry");
}

/// Not every law has kernels in every element.
void requireKernel(const Lineage& lineage, const Part& part)
{
    if (isKernel(kernelOf(part))) return;
    holder(lineage, "model")
        .fail("model",
              format("model {} is not there in the element of part '{}'", wordOf(part.kind),
                     part.name),
              "there are: " + elementsOf(part.kind));
}

/// Leading minors of a symmetric matrix xx yy zz xy yz zx.
bool isPositive(const std::array<double, 6>& m)
{
    const double second = m[0] * m[1] - m[3] * m[3];
    const double third =
        m[2] * second - m[4] * (m[0] * m[4] - m[3] * m[5]) + m[5] * (m[3] * m[4] - m[1] * m[5]);
    return m[0] > 0 && second > 0 && third > 0;
}

/// Inertia of some body: trace / 2 less the tensor, sum m x x^T, must be positive too.
std::array<double, 6> readInertia(const Dictionary& entry)
{
    const std::vector<double> values = entry.numbers("inertia");
    if (values.size() != 6)
        entry.fail("inertia", format("'inertia' has {} values, not 6", values.size()),
                   "write: inertia (xx yy zz xy yz zx), about the centre");
    std::array<double, 6> inertia{}, moments{};
    const double half = (values[0] + values[1] + values[2]) / 2;
    for (std::size_t i = 0; i < 6; ++i) {
        inertia[i] = values[i];
        moments[i] = (i < 3 ? half * (1 + 1e-9) : 0) - values[i];
    }
    if (!isPositive(inertia) || !isPositive(moments))
        entry.fail("inertia", "no body has this inertia",
                   "principal moments must be > 0, each at most the sum of the others; xy is "
                   "minus the sum of m x y");
    return inertia;
}

void readFreeBody(const Lineage& lineage, Part& part)
{
    GivenInertia& given = part.inertia;
    if (const Dictionary& entry = holder(lineage, "mass"); entry.has("mass"))
        given.mass = entry.number("mass", positive());
    if (const Dictionary& entry = holder(lineage, "centre"); entry.has("centre")) {
        given.hasCentre = true;
        given.centre = entry.vector("centre");
    }
    if (const Dictionary& entry = holder(lineage, "inertia"); entry.has("inertia")) {
        given.hasInertia = true;
        given.inertia = readInertia(entry);
    }
    if (given.hasCentre && !given.hasInertia)
        holder(lineage, "centre")
            .fail("centre", "'centre' is given without 'inertia'",
                  "the inertia about that centre does not follow from the mesh: give both");
    if (part.density == 0 && !(given.mass > 0 && given.hasInertia))
        lineage.front().fail("model",
                             "part '" + part.name + "' is rigidFree, but its mass is not known",
                             "add 'density', or 'mass' and 'inertia'");
}

void readRigid(const Lineage& lineage, Part& part)
{
    refuseFlow(lineage.front());
    part.density = holder(lineage, "density").numberOr("density", 0.0, nonNegative());
    part.youngsModulus =
        holder(lineage, "youngsModulus").numberOr("youngsModulus", 0.0, nonNegative());
    part.poissonsRatio =
        holder(lineage, "poissonsRatio").numberOr("poissonsRatio", 0.0, {-1, 0.5, true, true});
    if (part.kind == PartKind::rigidFree) readFreeBody(lineage, part);
}

Part readPart(const Dictionary& parts, const std::string& name)
{
    const Lineage lineage = lineageOf(parts, name);
    Part part;
    part.name = name;
    part.kind = readKind(lineage);
    if (isRigid(part.kind)) {
        readRigid(lineage, part);
        return part;
    }
    part.density = number(lineage, "density", positive());
    part.youngsModulus = number(lineage, "youngsModulus", positive());
    part.poissonsRatio = number(lineage, "poissonsRatio", {-1, 0.5, true, true});
    if (part.kind == PartKind::elastoplastic)
        readFlow(lineage, part);
    else if (part.kind == PartKind::elastic)
        checkUnusedFlow(lineage, part); // elastic and plastic differ by one word
    readLaw(lineage, part);
    readErosion(lineage, part);
    readElement(lineage, part);
    readHourglass(lineage, part);
    requireKernel(lineage, part);
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
        rigid.push_back(entries.has(part.name) && isRigid(readKind(lineageOf(entries, part.name))));
    return rigid;
}

} // namespace fpm
