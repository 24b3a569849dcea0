#include "model/PartMaterial.h"

#include "base/Format.h"

#include <algorithm>

namespace fpm {

static_assert(kindOf<Elastic> == PartKind::elastic);
static_assert(kindOf<J2Plasticity> == PartKind::elastoplastic);
static_assert(HourglassForms::indexOf<StiffnessHourglass>() == int(HourglassForm::stiffness)
              && HourglassForms::indexOf<ViscousHourglass>() == int(HourglassForm::viscous)
              && HourglassForms::indexOf<PhysicalHourglass>() == int(HourglassForm::physical));

namespace {

/// Whether a part asks for something that its law serves only with options chosen at run time.
bool needsOptions(const Part& part)
{
    return part.rotation != RotationForm::midSurface || part.hexahedron == HexahedronForm::selective
           || part.erosion.any() || (part.kind == PartKind::elastoplastic && part.flow != Flow{});
}

} // namespace

const MaterialEntry& materialOf(PartKind kind)
{
    return materialEntries.at(std::size_t(kind));
}

bool isPlastic(PartKind kind)
{
    return !isRigid(kind) && materialOf(kind).plastic;
}

std::vector<std::string> kindWords()
{
    std::vector<std::string> words;
    for (const MaterialEntry& material : materialEntries) words.push_back(material.word);
    for (const PartKind kind : {PartKind::rigidPrescribed, PartKind::rigidFree})
        words.push_back(wordOf(kind));
    return words;
}

std::string wordOf(PartKind kind)
{
    if (kind == PartKind::rigidPrescribed) return "rigidPrescribed";
    if (kind == PartKind::rigidFree) return "rigidFree";
    return materialOf(kind).word;
}

PartKind kindNamed(const std::string& word)
{
    for (std::size_t i = 0; i < materialEntries.size(); ++i)
        if (word == materialEntries[i].word) return PartKind(int(i));
    return word == wordOf(PartKind::rigidFree) ? PartKind::rigidFree : PartKind::rigidPrescribed;
}

ElementKernel kernelOf(const Part& part)
{
    const int element = part.hexahedron == HexahedronForm::selective
                            ? Elements::indexOf<SelectiveHexahedron>()
                            : reducedElement(int(part.hourglass));
    return kernelOf(int(part.kind), element, needsOptions(part));
}

std::string elementsOf(PartKind kind)
{
    std::string text;
    const int law = kernelOf(int(kind), 0, true).law;
    for (int element = 0; element < Elements::size; ++element)
        visitKernel({law, element}, [&]<class Law, class Element>() {
            text += format("{}hexahedron {}", text.empty() ? "" : ", ", Element::word);
            if constexpr (Element::hourglass != nullptr)
                text += format(" with hourglass form {}", Element::hourglass);
        });
    return text;
}

} // namespace fpm
