#include "advise/CostAdvice.h"

#include "base/Format.h"
#include "mesh/SmallElements.h"
#include "model/PartMaterial.h"

#include <cmath>

namespace fpm {

namespace {

constexpr double worthwhile = 1.2; ///< times the steps that the elements alone need
constexpr std::size_t manyElements = 1000;

std::string listOf(const std::vector<std::string>& names)
{
    std::string text = names.size() > 1 ? "parts" : "part";
    for (const std::string& name : names) text += " " + name;
    return text;
}

/// Of waves of compression.
double waveSpeed(const Part& part)
{
    const double nu = part.poissonsRatio;
    return std::sqrt(part.youngsModulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * part.density));
}

/// Whether the hourglass control of a part that may yield stays elastic.
bool staysElastic(const Part& part)
{
    const bool elastic = part.hourglass == HourglassForm::stiffness
                         || (part.hourglass == HourglassForm::physical
                             && part.hourglassPlastic == HourglassPlastic::elastic);
    return isPlastic(part.kind) && part.hexahedron == HexahedronForm::reduced && elastic;
}

} // namespace

std::optional<Advice> hourglassAdvice(const Model& model, const std::optional<Results>& results)
{
    Advice advice{"hourglass",
                  "",
                  "the section yields and its hourglass control stays elastic: it goes on to bear "
                  "what the material cannot (11 % of the path of tutorials/plateImpact, 16 to 52 % "
                  "of the radius of tutorials/taylorBar, whatever the mesh)",
                  "nothing; it costs up to a third more time an element, for a result that is "
                  "right on a coarse mesh",
                  "the result changes: that is its purpose; -measure shows by how much",
                  {},
                  false};
    std::vector<std::string> names;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const Part& part = model.parts[p];
        if (!staysElastic(part)) continue;
        if (results && !(results->parts[p].plasticStrain > 0)) continue;
        names.push_back(part.name);
        const std::string path = "parts." + part.name + ".hourglass.";
        advice.edits.set("constant/partProperties", path + "form", "physical");
        advice.edits.set("constant/partProperties", path + "coefficient", "1");
        advice.edits.set("constant/partProperties", path + "plastic", "coupled");
    }
    if (names.empty()) return {};
    advice.subject = format("{}: hourglass form physical, plastic coupled", listOf(names));
    return advice;
}

std::optional<Advice> contactStepAdvice(const Model& model, const Results& results)
{
    const Control& control = model.control;
    const bool isFree = control.fixedTimeStep == 0 && control.maximumTimeStep == 0;
    if (!results.steps || model.contactPairs.empty() || !isFree) return {};
    const StepFigures& steps = *results.steps;
    if (!(steps.count > 0) || !(steps.time > 0)) return {};
    const double times = steps.count * control.timeStepSafety * steps.elementStep / steps.time;
    if (!(times > worthwhile)) return {};
    const std::string last =
        steps.limit.empty() ? "" : format("; the last one was limited by {}", steps.limit);
    Advice advice{
        "step",
        "",
        format("the run made {} times the steps that its elements need: contact springs "
               "bound them{}",
               toText(times, 3), last),
        format("up to {} % of the steps; -measure shows it", toText(100 * (1 - 1 / times), 2)),
        "",
        {},
        true};
    if (control.contactStepLimit < 1) {
        advice.subject = format("timeStep.contactLimit 1 instead of {}", control.contactStepLimit);
        advice.price = "closing contacts may create energy: see the energy balance; softer "
                       "springs (normalScale) are the alternative, with deeper penetration";
        advice.edits.set("system/controlDict", "timeStep.contactLimit", "1");
        return advice;
    }
    advice.subject = "normalScale of all pairs times 0.3";
    advice.price = "surfaces sink three times as deep: right for bending, wrong for pressures";
    for (const ContactPair& pair : model.contactPairs)
        if (pair.hasSprings())
            advice.edits.set("system/contactDict", "pairs." + pair.name + ".normalScale",
                             toText(0.3 * pair.normalScale));
    return advice;
}

std::optional<Advice> elementsAdvice(const Model& model)
{
    std::vector<double> steps = elementHeights(model.mesh);
    for (std::size_t e = 0; e < steps.size(); ++e) {
        const Part& part = model.parts[std::size_t(model.mesh.partOf(Index(e)))];
        if (part.targetStep > 0) return {}; // mass scaling has seen to it
        steps[e] = isRigid(part.kind) ? 0 : steps[e] / waveSpeed(part);
    }
    const auto few = smallElements(model.mesh, steps);
    if (!few) return {};
    return Advice{
        "elements",
        smallElementsText(*few) + " set the time step",
        format("a wave crosses them {} times as fast as most elements", toText(few->ratio(), 3)),
        format("up to {} % of the steps", toText(100 * (1 - 1 / few->ratio()), 2)),
        "larger elements there, or massScaling.targetStep where inertia matters little: "
        "fpmExplicit -dryRun gives the mass it adds",
        {},
        false};
}

std::optional<Advice> threadsAdvice(const Model& model, int cores)
{
    const Control& control = model.control;
    const std::size_t elements = model.mesh.hexahedra.size();
    Advice advice{"threads", "",   "", "", "none: no bit depends on the number of threads",
                  {},        false};
    if (control.backend == "openmp" && control.threads > cores) {
        advice.subject = format("threads 0 instead of {}", control.threads);
        advice.reason = format("this machine has {} cores: threads without one hold up the others "
                               "in every step",
                               cores);
        advice.saving = "most of the time; -measure shows it";
    } else if (control.backend == "serial" && cores > 1 && elements >= manyElements) {
        advice.subject = "backend openmp, threads 0";
        advice.reason = format("{} elements on one of {} cores; 0 follows those that are idle",
                               elements, cores);
        advice.saving = "with two idle cores 1.3 to 1.9 times the speed; -measure shows it";
        advice.edits.set("system/controlDict", "backend", "openmp");
    } else
        return {};
    advice.edits.set("system/controlDict", "threads", "0");
    return advice;
}

} // namespace fpm
