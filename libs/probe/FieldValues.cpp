#include "probe/FieldValues.h"

#include "base/Error.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fpm {

namespace {

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::vector<double> column(const ResultField& field, std::size_t which)
{
    std::vector<double> values(field.values.size() / field.columns);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = field.values[i * field.columns + which];
    return values;
}

std::vector<double> magnitude(const ResultField& field)
{
    std::vector<double> values(field.values.size() / field.columns);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double* v = &field.values[3 * i];
        values[i] = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return values;
}

} // namespace

std::string FieldChoice::text() const
{
    return component.empty() ? field : field + " " + component;
}

FoundField findField(const Frame& frame, const std::string& name)
{
    std::vector<std::string> names;
    for (const bool onNodes : {true, false}) {
        for (const ResultField& field : onNodes ? frame.nodeFields : frame.elementFields) {
            if (field.name == name) return {&field, onNodes};
            names.push_back(field.name);
        }
    }
    throw Error(ExitCode::dictionary, "field '" + name + "' is not among the results of this case",
                "there are: " + joined(names));
}

std::vector<std::string> componentNames(std::size_t columns)
{
    if (columns == 1) return {""};
    if (columns == 3) return {"x", "y", "z"};
    if (columns == 6) return {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    std::vector<std::string> names;
    for (std::size_t i = 0; i < columns; ++i) names.push_back(std::to_string(i));
    return names;
}

ScalarField scalarField(const Frame& frame, const FieldChoice& choice)
{
    const auto [field, onNodes] = findField(frame, choice.field);
    const bool vector = field->columns == 3;
    if (vector && (choice.component.empty() || choice.component == "magnitude"))
        return {onNodes, magnitude(*field)};
    std::vector<std::string> names = componentNames(field->columns);
    const auto found = std::find(names.begin(), names.end(), choice.component);
    if (found != names.end()) return {onNodes, column(*field, std::size_t(found - names.begin()))};
    if (vector) names.push_back("magnitude");
    const std::string wrong =
        choice.component.empty()
            ? "field '" + choice.field + "' needs a component"
            : "field '" + choice.field + "' has no component '" + choice.component + "'";
    throw Error(ExitCode::dictionary, wrong,
                field->columns == 1 ? "it is a scalar: leave 'component' out"
                                    : "write component " + joined(names) + " (one of these)");
}

double mirrorSign(const std::string& component, const std::array<bool, 3>& mirrored)
{
    if (component == "magnitude") return 1;
    double sign = 1;
    for (const char letter : component) {
        const int axis = std::tolower(static_cast<unsigned char>(letter)) - 'x';
        if (axis >= 0 && axis < 3 && mirrored[std::size_t(axis)]) sign = -sign;
    }
    return sign;
}

} // namespace fpm
