#include "model/MaterialReader.h"

#include "base/Format.h"
#include "model/PartMaterial.h"

#include <limits>

namespace fpm {

namespace {

/// Entries that say how a part flows.
constexpr const char* flowKeys[] = {"yieldStress", "plasticModulus", "tangentModulus", "hardening",
                                    "johnsonCook", "kinematic",      "rate",           "heating"};

/// Each pair of these describes the same curve twice.
void refuseTwoCurves(const Dictionary& entry)
{
    const auto both = [&](const char* one, const char* other, const char* what) {
        if (entry.has(one) && entry.has(other))
            entry.fail(one, format("'{}' and '{}' both describe the {}", one, other, what),
                       "keep one of them");
    };
    for (const char* other : {"hardening", "johnsonCook"})
        for (const char* line : {"yieldStress", "plasticModulus", "tangentModulus"})
            both(line, other, "yield stress");
    both("hardening", "johnsonCook", "yield stress");
    both("plasticModulus", "tangentModulus", "hardening");
}

std::vector<Hardening> readTable(const Dictionary& entry)
{
    if (entry.leadingWord("hardening") != "table")
        entry.fail("hardening", "unknown hardening '" + entry.leadingWord("hardening") + "'",
                   "write: hardening table ((0 285) (0.1 375)), rows of equivalent plastic strain "
                   "and yield stress");

    std::vector<Hardening> table;
    for (const auto& row : entry.tailRows("hardening", 2)) {
        const bool first = table.empty();
        if (first ? row[0] != 0 : row[0] <= table.back().equivalentPlasticStrain)
            entry.fail("hardening", first ? "the first row must be at plastic strain 0"
                                          : "plastic strains must ascend: " + toText(row[0], 6)
                                                + " follows "
                                                + toText(table.back().equivalentPlasticStrain, 6));
        if (row[1] <= 0 || (!first && row[1] < table.back().yieldStress))
            entry.fail("hardening",
                       "yield stresses must be > 0 and must not fall: " + toText(row[1], 6),
                       "softening gives results that depend on the mesh and is refused");
        table.push_back({row[0], row[1]});
    }
    if (table.empty()) entry.fail("hardening", "the table has no rows");
    if (table.size() > mostHardeningRows)
        entry.fail("hardening", format("the table has {} rows", table.size()),
                   format("at most {}: leave out rows on a straight line", mostHardeningRows));
    return table;
}

/// Plastic modulus H; from the tangent modulus of the uniaxial curve, H = E E_T / (E - E_T).
double readModulus(const Lineage& lineage, double young)
{
    for (const Dictionary& entry : lineage) {
        if (entry.has("plasticModulus")) return entry.number("plasticModulus", nonNegative());
        if (!entry.has("tangentModulus")) continue;
        const double tangent = entry.number("tangentModulus", nonNegative());
        if (!(tangent < young))
            entry.fail(
                "tangentModulus",
                format("a tangent modulus of {} is not below Young's modulus {}", tangent, young),
                "it is the slope of the uniaxial stress-strain curve beyond yield");
        return young * tangent / (young - tangent);
    }
    return 0;
}

void readJohnsonCook(const Dictionary& entry, Part& part)
{
    Flow& flow = part.flow;
    const double a = entry.number("A", positive());
    part.hardening = {{0.0, a}};
    flow.powerModulus = entry.number("B", nonNegative());
    flow.powerExponent = entry.number("n", {0, 1, true, false});
    flow.rateCoefficient = entry.numberOr("C", 0, nonNegative());
    if (flow.rateCoefficient > 0) {
        flow.rate = RateDependence::johnsonCook;
        flow.referenceRate = entry.number("rate0", positive());
    } else
        entry.numberOr("rate0", 1, positive());
    flow.softeningExponent = entry.numberOr("m", 0, nonNegative());
    flow.roomTemperature = entry.numberOr("room", 293, nonNegative());
    if (flow.softeningExponent > 0)
        flow.meltingTemperature = entry.number(
            "melt", {flow.roomTemperature, std::numeric_limits<double>::infinity(), true, false});
    else
        entry.numberOr("melt", 0, nonNegative());
}

/// The nearest of the lineage that speaks of hardening decides between table, straight line and
/// Johnson and Cook's curve. True for the straight line.
bool readHardening(const Lineage& lineage, Part& part)
{
    for (const Dictionary& entry : lineage) {
        refuseTwoCurves(entry);
        if (entry.has("hardening")) {
            part.hardening = readTable(entry);
            return false;
        }
        if (entry.has("johnsonCook")) {
            readJohnsonCook(entry.sub("johnsonCook"), part);
            return false;
        }
        if (entry.has("yieldStress") || entry.has("plasticModulus") || entry.has("tangentModulus"))
            break;
    }
    const double yieldStress = number(lineage, "yieldStress", positive());
    const double modulus = readModulus(lineage, part.youngsModulus);
    part.hardening = {{0.0, yieldStress}, {1.0, yieldStress + modulus}};
    return true;
}

void readKinematic(const Lineage& lineage, bool straight, Part& part)
{
    const Dictionary& owner = holder(lineage, "kinematic");
    if (!owner.has("kinematic")) return;
    const Dictionary entry = owner.sub("kinematic");
    if (!entry.has("fraction")) {
        part.flow.kinematicModulus = entry.number("modulus", nonNegative());
        return;
    }
    if (entry.has("modulus"))
        entry.fail("fraction", "'fraction' and 'modulus' both describe the kinematic hardening",
                   "keep one of them");
    if (!straight)
        entry.fail("fraction", "a fraction is that of a straight line's plastic modulus",
                   "give the modulus of the backstress: kinematic { modulus 900; }");
    const double fraction = entry.number("fraction", between(0, 1));
    const double yieldStress = part.hardening[0].yieldStress,
                 modulus = part.hardening[1].yieldStress - yieldStress;
    part.flow.kinematicModulus = fraction * modulus;
    part.hardening[1].yieldStress = yieldStress + (1 - fraction) * modulus;
}

void readRate(const Lineage& lineage, Part& part)
{
    const Dictionary& owner = holder(lineage, "rate");
    if (!owner.has("rate")) return;
    const Dictionary entry = owner.sub("rate");
    Flow& flow = part.flow;
    const std::string law = entry.choice("law", {"none", "cowperSymonds", "johnsonCook"});
    if (law == "none") return;
    if (flow.rate != RateDependence::none)
        entry.fail("law", "'johnsonCook' has a rate term of its own, C",
                   "leave out 'rate', or C and rate0 of johnsonCook");
    if (law == "cowperSymonds") {
        flow.rate = RateDependence::cowperSymonds;
        flow.referenceRate = entry.number("D", positive());
        flow.rateCoefficient = 1 / entry.number("p", {1, 100, false, false});
    } else {
        flow.rateCoefficient = entry.number("C", positive());
        flow.rate = RateDependence::johnsonCook;
        flow.referenceRate = entry.number("rate0", positive());
    }
}

void readHeating(const Lineage& lineage, Part& part)
{
    Flow& flow = part.flow;
    flow.temperature = flow.roomTemperature;
    const Dictionary& owner = holder(lineage, "heating");
    if (!owner.has("heating")) return;
    const Dictionary entry = owner.sub("heating");
    flow.heatFraction = entry.numberOr("fraction", 0.9, between(0, 1));
    flow.specificHeat = entry.number("specificHeat", positive());
    flow.temperature = entry.numberOr("temperature", flow.roomTemperature, nonNegative());
}

std::vector<double> readParameters(const Dictionary& entry, const MaterialEntry& material)
{
    std::vector<double> values;
    for (const Parameter& p : material.parameters) {
        const Range range{p.lower, p.upper, p.lowerOpen, p.upperOpen};
        values.push_back(p.required ? entry.number(p.word, range)
                                    : entry.numberOr(p.word, p.preset, range));
    }
    const ParameterFault fault = material.fault(values.data());
    if (fault.parameter >= 0)
        entry.fail(material.parameters[std::size_t(fault.parameter)].word, fault.message,
                   fault.advice);
    return values;
}

} // namespace

void readFlow(const Lineage& lineage, Part& part)
{
    const bool straight = readHardening(lineage, part);
    readKinematic(lineage, straight, part);
    readRate(lineage, part);
    readHeating(lineage, part);
}

void checkUnusedFlow(const Lineage& lineage, const Part& part)
{
    for (const char* key : flowKeys)
        if (lineage.front().has(key)) {
            Part plastic = part;
            readFlow(lineage, plastic);
            return;
        }
}

void readLaw(const Lineage& lineage, Part& part)
{
    const MaterialEntry& own = materialOf(part.kind);
    for (const MaterialEntry& material : materialEntries) {
        if (material.parameters.empty()) continue;
        const Dictionary& owner = holder(lineage, material.word);
        const bool used = material.word == own.word;
        if (used || lineage.front().has(material.word)) {
            const std::vector<double> values = readParameters(owner.sub(material.word), material);
            if (used) part.lawValues = values;
        }
    }
    if (own.parameters.empty()) return;
    for (const std::string key : flowKeys)
        if (!(own.heats && key == "heating") && lineage.front().has(key))
            lineage.front().fail(
                key, format("'{}' has no meaning for model {}", key, own.word),
                format("its numbers stand in the dictionary '{}'; remove it", own.word));
    if (own.heats) readHeating(lineage, part);
}

void readErosion(const Lineage& lineage, Part& part)
{
    const Dictionary& owner = holder(lineage, "erosion");
    if (!owner.has("erosion")) return;
    const Dictionary entry = owner.sub("erosion");
    part.erosion.inverted = entry.switchOr("inverted", false);
    if (entry.has("plasticStrain")) {
        const double limit = entry.number("plasticStrain", positive());
        // An elastic part never gets there: checked, not used.
        if (isPlastic(part.kind)) part.erosion.plasticStrain = limit;
    } else if (!part.erosion.inverted)
        entry.fail("plasticStrain", "'erosion' says not when elements are deleted",
                   "write: erosion { plasticStrain 0.8; }, or inverted yes, or both");
}

void refuseFlow(const Dictionary& own)
{
    const auto refuse = [&](const char* key, const std::string& instead) {
        if (own.has(key))
            own.fail(key, format("'{}' has no meaning for a rigid part", key), instead);
    };
    for (const char* key : flowKeys) refuse(key, "use model elastoplastic, or remove it");
    for (const MaterialEntry& material : materialEntries)
        if (!material.parameters.empty())
            refuse(material.word, format("use model {}, or remove it", material.word));
    refuse("erosion", "use model elastic or elastoplastic, or remove it");
}

} // namespace fpm
