#include "study/CaseSurvey.h"

#include "base/Format.h"
#include "dictionary/Number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fpm {

namespace {

Dictionary dictionaryOrEmpty(const Case& theCase, const std::string& file)
{
    return theCase.hasFile(file) ? theCase.dictionary(file) : Dictionary::parse("", file);
}

/// Edges of the elements of a body, and how many it has.
struct BodySize {
    std::array<double, 3> edges;
    double elements;
};

std::vector<std::int64_t> countsOf(const Dictionary& body, const std::string& key)
{
    std::vector<std::int64_t> counts;
    if (body.isList(key))
        for (const double count : body.numbers(key)) counts.push_back(std::llround(count));
    else
        counts.push_back(body.integer(key, 1, 1'000'000));
    return counts;
}

BodySize sizeOfBox(const Dictionary& body, double layers)
{
    const Point size = body.vector("size"), cells = body.vector("cells");
    return {{size[0] / cells[0], size[1] / cells[1], size[2] / (cells[2] * layers)},
            cells[0] * cells[1] * cells[2] * layers};
}

double quarters(const Dictionary& body)
{
    const std::string sector = body.wordOr("sector", "full");
    return sector == "quarter" ? 1 : sector == "half" ? 2 : 4;
}

BodySize sizeOfCylinder(const Dictionary& body)
{
    const double core = double(body.integer("core", 1, 2000)),
                 rings = double(body.integer("rings", 1, 2000)),
                 axial = double(body.integer("axial", 1, 100'000)), radius = body.number("radius");
    // 0.55: where the inner block ends.
    return {{0.55 * radius / core, 0.45 * radius / rings, body.number("height") / axial},
            quarters(body) * core * (core + 2 * rings) * axial};
}

BodySize sizeOfTube(const Dictionary& body)
{
    const double around = double(body.integer("circumferential", 1, 100'000)),
                 radial = double(body.integer("radial", 1, 2000)),
                 axial = double(body.integer("axial", 1, 100'000)),
                 inner = body.number("innerRadius"), outer = body.number("outerRadius");
    const double arc = quarters(body) * std::numbers::pi / 4 * (inner + outer);
    return {{arc / around, (outer - inner) / radial, body.number("height") / axial},
            around * radial * axial};
}

void surveyBodies(const Dictionary& bodies, CaseSurvey& found)
{
    double most = 0;
    for (const std::string& name : bodies.keys()) {
        const Dictionary body = bodies.sub(name);
        const std::string type = body.wordOr("type", "");
        BodySize size{};
        std::vector<std::string> keys;
        if (type == "box" || type == "layers") {
            size = sizeOfBox(body, type == "box" ? 1 : double(body.integer("count", 1, 1000)));
            keys = {"cells"};
        } else if (type == "cylinder") {
            size = sizeOfCylinder(body);
            keys = {"core", "rings", "axial"};
        } else if (type == "hollowCylinder") {
            size = sizeOfTube(body);
            keys = {"circumferential", "radial", "axial"};
        } else
            found.fromFile = true;
        for (const std::string& key : keys)
            found.cells.push_back({"meshDict.bodies." + name + "." + key, countsOf(body, key)});
        found.elements += size.elements;
        if (size.elements <= most) continue;
        most = size.elements;
        found.size = *std::max_element(size.edges.begin(), size.edges.end());
    }
}

/// An entry of a part or of those it is like.
std::string inherited(const Dictionary& parts, std::string name, const std::string& key)
{
    for (int depth = 0; depth < 100 && parts.isDictionary(name); ++depth) {
        const Dictionary part = parts.sub(name);
        if (part.has(key)) return part.word(key);
        name = part.wordOr("like", "");
    }
    return "";
}

void surveyParts(const Dictionary& parts, CaseSurvey& found)
{
    for (const std::string& name : parts.keys())
        found.plastic |= inherited(parts, name, "model") == "elastoplastic";
    for (const std::string& name : parts.keys()) {
        const std::string model = inherited(parts, name, "model");
        const Dictionary part = parts.sub(name);
        const bool isOwn = !part.has("like") || part.has("hourglass") || part.has("hexahedron");
        if (isOwn && model == (found.plastic ? "elastoplastic" : "elastic"))
            found.parts.push_back(name);
    }
}

/// Analytic surfaces have springs only where they are asked for.
bool hasSprings(const Dictionary& pair, const Dictionary& surfaces)
{
    const std::string target = pair.wordOr("target", "");
    return !surfaces.isDictionary(target) || !surfaces.sub(target).has("type")
           || pair.wordOr("enforcement", "") == "penalty";
}

void surveyPairs(const Dictionary& contactDict, CaseSurvey& found)
{
    const Dictionary pairs = contactDict.subOrEmpty("pairs"),
                     surfaces = contactDict.subOrEmpty("surfaces");
    for (const std::string& name : pairs.keys())
        if (pairs.isDictionary(name) && hasSprings(pairs.sub(name), surfaces))
            found.pairs.emplace_back(name, pairs.sub(name).numberOr("normalScale", 1));
}

/// The axis along which most is driven, pushed or thrown.
std::string mainAxis(const Case& theCase)
{
    std::array<int, 3> votes{0, 0, 0};
    const auto vote = [&](const Dictionary& entry, const std::string& key) {
        if (!entry.isList(key)) return;
        const Point v = entry.vector(key);
        std::size_t axis = 0;
        for (std::size_t c = 1; c < 3; ++c)
            if (std::abs(v[c]) > std::abs(v[axis])) axis = c;
        if (v[axis] != 0) ++votes[axis];
    };
    for (const char* file : {"0/initialConditions", "constant/boundaryConditions"}) {
        const Dictionary entries = dictionaryOrEmpty(theCase, file);
        for (const std::string& name : entries.keys())
            if (entries.isDictionary(name)) vote(entries.sub(name), "value");
    }
    const Dictionary surfaces =
        dictionaryOrEmpty(theCase, "system/contactDict").subOrEmpty("surfaces");
    for (const std::string& name : surfaces.keys())
        for (const char* key : {"displacement", "velocity"})
            vote(surfaces.sub(name).subOrEmpty("motion"), key);
    const auto most = std::max_element(votes.begin(), votes.end());
    return *most == 0 ? "z" : std::string(1, "xyz"[most - votes.begin()]);
}

void surveyHistories(const Dictionary& functions, const std::string& axis, CaseSurvey& found)
{
    const auto add = [&](const std::string& name, const std::string& file, const std::string& y) {
        found.columns.push_back({name, format("postProcessing/{}/0/{}.dat", name, file), y});
    };
    std::string energies;
    for (const std::string& name : functions.keys()) {
        const Dictionary function = functions.sub(name);
        const std::string type = function.wordOr("type", "");
        if (type == "point") {
            const auto fields = function.has("fields") ? function.words("fields")
                                                       : std::vector<std::string>{"displacement"};
            const std::string& field = fields.front();
            add(name, field, (field == "displacement" ? "u" : field.substr(0, 1)) + axis);
        } else if (type == "reaction")
            add(name, "reaction", "f" + axis);
        else if (type == "rigidBody")
            add(name, "rigidBody", "u" + axis);
        else if (type == "part")
            add(name, "part", "p" + axis);
        else if (type == "energies")
            energies = name;
    }
    if (found.columns.empty() && !energies.empty()) add(energies, "energies", "internal");
}

} // namespace

CaseSurvey surveyOf(const Case& theCase)
{
    CaseSurvey found;
    surveyBodies(dictionaryOrEmpty(theCase, "system/meshDict").subOrEmpty("bodies"), found);
    surveyParts(dictionaryOrEmpty(theCase, "constant/partProperties").subOrEmpty("parts"), found);
    surveyPairs(dictionaryOrEmpty(theCase, "system/contactDict"), found);
    surveyHistories(dictionaryOrEmpty(theCase, "system/controlDict").subOrEmpty("functions"),
                    mainAxis(theCase), found);
    return found;
}

} // namespace fpm
