#include "run/KernelReport.h"

#include "base/Format.h"

#include <map>

namespace fpm {

namespace {

/// Material, integration and hourglass control.
std::string elementKernel(const KernelGroup& group)
{
    std::string text;
    visitKernel(group.kernel, [&]<class Material, class Element>() {
        text = format("{}, {}", Element::name, Material::name);
        if constexpr (Element::hourglass != nullptr)
            text += format(", hourglass {}", Element::hourglass);
    });
    return text;
}

std::string elementLine(const KernelGroup& group, const Solver& solver, const Model& model)
{
    std::map<std::size_t, Index> elements; // of each part
    for (const Index number : group.patches) {
        const PatchHeader& patch = solver.elements().setUp().patches[std::size_t(number)];
        elements[std::size_t(patch.material)] += patch.elementCount;
    }
    std::string parts, floats;
    std::size_t least = 1000, most = 0;
    const bool precise = model.control.precision == Precision::double_,
               single = model.control.precision == Precision::single;
    for (const auto& [part, count] : elements) {
        parts += " " + model.parts[part].name;
        const StateLayout& layout = solver.elements().setUp().layouts[part];
        if (layout.floatHourglass) floats += " " + model.parts[part].name;
        const std::size_t bytes = std::size_t(layout.size()) * (precise ? 8 : 4)
                                  + std::size_t(layout.sums()) * (single ? 4 : 8);
        least = std::min(least, bytes);
        most = std::max(most, bytes);
    }
    return format("elements of{}: {}; {}{} bytes of state each{}", parts, elementKernel(group),
                  least, least < most ? format(" to {}", most) : std::string(),
                  floats.empty() ? floats : "; hourglass forces as float:" + floats);
}

std::string pairLine(const ContactPassSetup& pass, const ContactPair& pair, const Model& model)
{
    std::string does;
    const auto add = [&](bool acts, const std::string& what) {
        if (acts) does += (does.empty() ? "" : ", ") + what;
    };
    if (pass.surface >= 0)
        does = "analytic surface " + model.rigidSurfaces[std::size_t(pass.surface)].name
               + (pass.kinematic ? ", met exactly" : ", springs");
    else if (pass.ofEdges)
        does = "sharp edges";
    else {
        add(pass.search == ContactSearch::faces, "search faces");
        add(pass.search == ContactSearch::closestParticle, "search closestParticle");
        add(pass.projection == ContactProjection::cold, "cold projection");
    }
    add(pass.law.friction > 0,
        pass.law.paperFriction && !pass.kinematic ? "friction of the paper" : "friction");
    add(pass.law.normalDamping > 0 && !pass.kinematic, "damping");
    add(pass.components > 1, "several bodies a node");
    add(pass.forgives, "initial overlap forgiven");
    if (pass.ofEdges)
        return format("contact {}: {}; {} segments", pair.name, does, pass.faceThickness.size());
    return format("contact {}{}: {}; {} contactors on {} faces", pair.name,
                  pass.reversed ? ", second pass" : "", does, pass.contactor.size(),
                  pass.faceThickness.size());
}

} // namespace

std::vector<std::string> kernelLines(const Solver& solver, const Model& model)
{
    std::vector<std::string> lines;
    for (const KernelGroup& group : solver.elements().setUp().groups)
        lines.push_back(elementLine(group, solver, model));
    std::string rigid;
    for (const Part& part : model.parts)
        if (isRigid(part.kind)) rigid += " " + part.name;
    if (!rigid.empty()) lines.push_back("no element work:" + rigid + ", rigid");
    for (const ContactPassSetup& pass : solver.contact().setUp().passes)
        lines.push_back(pairLine(pass, model.contactPairs[pass.pair], model));
    return lines;
}

} // namespace fpm
