#include "model/CaseReader.h"

#include "base/Format.h"
#include "model/PointAlgebra.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

struct Unit {
    const char* name;
    double si; ///< metres, kilograms or seconds in one
};
constexpr std::array<Unit, 7> lengthUnits{{{"m", 1.0},
                                           {"cm", 1e-2},
                                           {"mm", 1e-3},
                                           {"um", 1e-6},
                                           {"km", 1e3},
                                           {"inch", 0.0254},
                                           {"foot", 0.3048}}};
constexpr std::array<Unit, 7> massUnits{{{"kg", 1.0},
                                         {"g", 1e-3},
                                         {"mg", 1e-6},
                                         {"tonne", 1e3},
                                         {"pound", 0.45359237},
                                         {"slug", 14.593903},
                                         {"slinch", 175.126836}}};
constexpr std::array<Unit, 3> timeUnits{{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}}};

template <std::size_t n>
std::vector<std::string> namesOf(const std::array<Unit, n>& units)
{
    std::vector<std::string> names;
    for (const Unit& unit : units) names.push_back(unit.name);
    return names;
}

template <std::size_t n>
double factorOf(const std::array<Unit, n>& units, const std::string& name)
{
    const auto found = std::find_if(units.begin(), units.end(),
                                    [&](const Unit& unit) { return name == unit.name; });
    if (found == units.end()) throw Error(ExitCode::internal, "unit '" + name + "' has no factor");
    return found->si;
}

} // namespace

CaseProperties readCaseProperties(const Dictionary& dictionary)
{
    CaseProperties properties;
    properties.title = dictionary.wordOr("title", "");
    const Dictionary units = dictionary.sub("units");
    properties.units = {units.choice("length", namesOf(lengthUnits)),
                        units.choice("mass", namesOf(massUnits)),
                        units.choice("time", namesOf(timeUnits))};
    dictionary.requireAllUsed();
    return properties;
}

double metresPerSecond(const std::array<std::string, 3>& units)
{
    return factorOf(lengthUnits, units[0]) / factorOf(timeUnits, units[2]);
}

namespace {

/// "kN" of 1e3 newton; empty where no prefix says it.
std::string prefixed(double inSi, const std::string& unit)
{
    constexpr std::array<std::pair<const char*, double>, 6> prefixes{
        {{"u", 1e-6}, {"m", 1e-3}, {"", 1}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}}};
    for (const auto& [prefix, factor] : prefixes)
        if (std::abs(inSi / factor - 1) < 1e-9) return prefix + unit;
    return "";
}

} // namespace

std::string unitOf(Quantity quantity, const std::array<std::string, 3>& units)
{
    const auto& [length, mass, time] = units;
    const double metre = factorOf(lengthUnits, length), speed = metresPerSecond(units),
                 newton = factorOf(massUnits, mass) * speed / factorOf(timeUnits, time);
    switch (quantity) {
    case Quantity::none:
        break;
    case Quantity::time:
        return time;
    case Quantity::length:
        return length;
    case Quantity::velocity:
        return format("{}/{}", length, time);
    case Quantity::acceleration:
        return format("{}/{}^2", length, time);
    case Quantity::spin:
        return format("rad/{}", time);
    case Quantity::force: {
        const std::string name = prefixed(newton, "N");
        return name.empty() ? format("{}*{}/{}^2", mass, length, time) : name;
    }
    case Quantity::moment: {
        const std::string name = prefixed(newton, "N");
        return name.empty() ? format("{}*{}^2/{}^2", mass, length, time)
                            : format("{}*{}", name, length);
    }
    case Quantity::momentum:
        return format("{}*{}", unitOf(Quantity::force, units), time);
    case Quantity::angularMomentum:
        return format("{}*{}", unitOf(Quantity::moment, units), time);
    case Quantity::energy: {
        const std::string name = prefixed(newton * metre, "J");
        return name.empty() ? format("{}*{}^2/{}^2", mass, length, time) : name;
    }
    }
    return "-";
}

double waveSpeed(const Part& part)
{
    const double nu = part.poissonsRatio;
    const double modulus = part.youngsModulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    return std::sqrt(modulus / part.density);
}

namespace {

/// "(mm tonne s)", as a question ends with it.
std::string unitsText(const std::array<std::string, 3>& units)
{
    return format("in the units of constant/caseProperties ({} {} {})", units[0], units[1],
                  units[2]);
}

} // namespace

void checkUnits(const std::vector<Part>& parts, const std::array<std::string, 3>& units, Log& log)
{
    const double toSi = metresPerSecond(units), length = factorOf(lengthUnits, units[0]),
                 toDensity = factorOf(massUnits, units[1]) / (length * length * length);
    for (const Part& part : parts) {
        const double speed = isRigid(part.kind) ? 1000 : waveSpeed(part) * toSi,
                     density = part.density * toDensity;
        if (!(speed >= 50 && speed <= 20000))
            log.warning(format("part '{}': its wave speed would be {} m/s, solids have 50 to "
                               "20000; are density {} and youngsModulus {} {}?",
                               part.name, speed, part.density, part.youngsModulus,
                               unitsText(units)));
        else if (density > 0 && !(density >= 1 && density <= 30000))
            log.warning(format("part '{}': its density would be {} kg/m3, solids have 1 to 30000; "
                               "is density {} {}?",
                               part.name, density, part.density, unitsText(units)));
    }
}

void checkGravity(const std::vector<BoundaryCondition>& conditions,
                  const std::array<std::string, 3>& units,
                  Log& log)
{
    const double toSi = metresPerSecond(units) / factorOf(timeUnits, units[2]);
    for (const BoundaryCondition& condition : conditions) {
        if (condition.kind != BoundaryCondition::Kind::gravity) continue;
        double factor = 0;
        for (const auto& row : condition.amplitude.rows)
            factor = std::max(factor, std::abs(row[1]));
        const double given = factor * length(condition.value), found = given * toSi;
        if (!(found > 0) || (found >= 0.1 && found <= 1000)) continue;
        log.warning(format("gravity '{}': its acceleration would be {} m/s2, gravity is 9.81 and "
                           "loads of its kind 0.1 to 1000; is {} {}? 9.81 m/s2 are {} there",
                           condition.name, found, given, unitsText(units), toText(9.81 / toSi, 6)));
    }
}

} // namespace fpm
