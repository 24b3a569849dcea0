#include "stability/StabilityDict.h"

#include "base/Format.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

std::vector<std::string> sceneNames()
{
    std::vector<std::string> names{"case"};
    for (const Scene& scene : probeScenes()) names.push_back(scene.name);
    return names;
}

std::vector<std::string> parametersOf(const std::string& scene)
{
    for (const Scene& known : probeScenes())
        if (known.name == scene) return known.parameters;
    return caseScene(Model{}).parameters;
}

/// What a parameter may be.
Range rangeOf(const std::string& name)
{
    if (name == parameter::gap) return {0, 10, false, false};
    if (name == parameter::search) return {0, 1e6, false, false};
    if (name == parameter::timeStep) return {0, 10, true, false};
    if (name == parameter::penalty || name == parameter::hourglass) return {0, 1e6, true, false};
    return {0, 1e9, true, false};
}

void requireInRange(const Dictionary& dictionary,
                    const std::string& key,
                    const std::string& name,
                    double value)
{
    const Range range = rangeOf(name);
    if (!range.holds(value))
        dictionary.fail(key, format("{} {} is not {}", name, value, range.text()));
}

MapAxis readAxis(const Dictionary& dictionary, const std::vector<std::string>& parameters)
{
    MapAxis axis;
    axis.parameter = dictionary.choice("parameter", parameters);
    axis.logarithmic =
        dictionary.choiceOr("spacing", "linear", {"linear", "logarithmic"}) == "logarithmic";
    if (dictionary.has("values")) {
        axis.values = dictionary.numbers("values");
        if (axis.values.empty() || axis.values.size() > 200
            || !std::is_sorted(axis.values.begin(), axis.values.end(), std::less_equal<>{}))
            dictionary.fail("values", "expected 1 to 200 numbers, each larger than the one before");
        requireInRange(dictionary, "values", axis.parameter, axis.values.front());
        requireInRange(dictionary, "values", axis.parameter, axis.values.back());
    } else {
        const double from = dictionary.number("from"), to = dictionary.number("to");
        const std::int64_t points = dictionary.integer("points", 2, 200);
        if (!(from < to)) dictionary.fail("to", "it must be larger than from");
        requireInRange(dictionary, "from", axis.parameter, from);
        requireInRange(dictionary, "to", axis.parameter, to);
        if (axis.logarithmic && !(from > 0))
            dictionary.fail("from", "logarithmic spacing begins above 0");
        for (std::int64_t i = 0; i < points; ++i) {
            const double share = double(i) / double(points - 1);
            axis.values.push_back(axis.logarithmic ? from * std::pow(to / from, share)
                                                   : from + share * (to - from));
        }
    }
    if (axis.logarithmic && !(axis.values.front() > 0))
        dictionary.fail("values", "logarithmic spacing begins above 0");
    return axis;
}

TrialLimits readLimits(const Dictionary& map)
{
    TrialLimits limits;
    limits.steps = int(map.integerOr("steps", limits.steps, 10, 1000000));
    const Dictionary given = map.subOrEmpty("limits");
    limits.energy = given.numberOr("energy", limits.energy, positive());
    limits.penetration = given.numberOr("penetration", limits.penetration, positive());
    limits.chatter = given.numberOr("chatter", limits.chatter, positive());
    return limits;
}

MapSpec readMap(const Dictionary& dictionary, const std::string& name)
{
    MapSpec map;
    map.name = name;
    map.scene = dictionary.choice("scene", sceneNames());
    const std::vector<std::string> parameters = parametersOf(map.scene);
    map.x = readAxis(dictionary.sub("x"), parameters);
    map.y = readAxis(dictionary.sub("y"), parameters);
    if (map.x.parameter == map.y.parameter)
        dictionary.sub("y").fail("parameter", "both axes vary " + map.x.parameter);
    const Dictionary fixed = dictionary.subOrEmpty("fixed");
    for (const std::string& key : parameters) {
        if (!fixed.has(key)) continue;
        if (key == map.x.parameter || key == map.y.parameter) fixed.fail(key, "an axis varies it");
        map.fixed.set(key, fixed.number(key, rangeOf(key)));
    }
    map.limits = readLimits(dictionary);
    map.eigenvalue = dictionary.switchOr("eigenvalue", map.x.parameter == parameter::timeStep);
    if (map.eigenvalue && map.x.parameter != parameter::timeStep)
        dictionary.fail("eigenvalue", "it is drawn where x is " + parameter::timeStep);
    return map;
}

} // namespace

std::vector<MapSpec> readStabilityDict(const Dictionary& dictionary)
{
    std::vector<MapSpec> maps;
    const Dictionary all = dictionary.sub("maps");
    for (const std::string& name : all.keys()) {
        const bool safe = std::all_of(name.begin(), name.end(), [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
        });
        if (!safe)
            all.fail(name, "'" + name + "' cannot be a file name", "letters, digits, _ and -");
        maps.push_back(readMap(all.sub(name), name));
    }
    if (maps.empty()) dictionary.fail("maps", "no map to draw");
    dictionary.requireAllUsed();
    return maps;
}

} // namespace fpm
