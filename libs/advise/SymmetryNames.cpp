#include "advise/SymmetryNames.h"

#include "base/Format.h"

#include <algorithm>

namespace fpm {

namespace {

std::string amplitudeText(const Amplitude& amplitude)
{
    if (amplitude.kind == Amplitude::Kind::constant) return "constant";
    std::string rows;
    for (const auto& row : amplitude.rows)
        rows += format("{}({} {})", rows.empty() ? "" : " ", toText(row[0]), toText(row[1]));
    return format("{} ({})", amplitude.kind == Amplitude::Kind::table ? "table" : "smooth", rows);
}

} // namespace

std::string FreeNames::free(const std::string& name, const Model& model, const Mesh& mesh)
{
    const auto used = [&](const std::string& word) {
        return given_.count(word) > 0 || mesh.nodeSets.count(word) > 0
               || mesh.sideSets.count(word) > 0 || mesh.findPart(word) >= 0
               || std::any_of(model.boundaryConditions.begin(), model.boundaryConditions.end(),
                              [&](const BoundaryCondition& c) { return c.name == word; });
    };
    std::string word = name;
    for (int number = 1; used(word); ++number) word = format("{}_{}", name, number);
    given_.insert(word);
    return word;
}

std::string vectorText(const Point& vector, double factor)
{
    return format("({} {} {})", toText(factor * vector[0]), toText(factor * vector[1]),
                  toText(factor * vector[2]));
}

std::string forceText(const BoundaryCondition& condition, const std::string& name, double share)
{
    std::string components;
    for (std::size_t c = 0; c < 3; ++c)
        if (condition.constrains[c])
            components += std::string(components.empty() ? "" : " ") + "xyz"[c];
    std::string axes;
    if (!condition.isGlobal())
        axes = format(" axes ({} {});", vectorText(condition.axes[0], 1),
                      vectorText(condition.axes[1], 1));
    return format("{} { type force; set {}; value {}; components ({});{} amplitude {}; }\n", name,
                  name, vectorText(condition.value, share), components, axes,
                  amplitudeText(condition.amplitude));
}

} // namespace fpm
