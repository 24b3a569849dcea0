#include "probe/TableProbe.h"

#include "base/Error.h"
#include "mesh/Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fpm {

namespace {

[[noreturn]] void refuseName(const std::string& what, const std::string& known)
{
    throw Error(ExitCode::dictionary, "the mesh has no " + what,
                known.empty() ? "it has none at all" : "there are:" + known);
}

std::vector<Index> range(std::size_t count)
{
    std::vector<Index> numbers(count);
    std::iota(numbers.begin(), numbers.end(), Index(0));
    return numbers;
}

void sortUnique(std::vector<Index>& numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

Point elementCentre(const Mesh& mesh, Index element)
{
    Point centre{0, 0, 0};
    for (const Index node : mesh.hexahedra[std::size_t(element)])
        for (std::size_t k = 0; k < 3; ++k) centre[k] += mesh.points[std::size_t(node)][k] / 8;
    return centre;
}

/// Of the values that there are: NaN stands where a field has none, and alone remains.
double reduce(std::vector<double> values, TableSpec::Operation operation)
{
    using enum TableSpec::Operation;
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (operation == min) return *std::min_element(values.begin(), values.end());
    if (operation == max) return *std::max_element(values.begin(), values.end());
    const double total = std::accumulate(values.begin(), values.end(), 0.0);
    return operation == sum ? total : total / double(values.size());
}

/// Nodes and elements of a part (all for an empty name).
void selectPart(const TableSpec& spec,
                const Mesh& mesh,
                std::vector<Index>& nodes,
                std::vector<Index>& elements)
{
    if (spec.part.empty()) {
        nodes = range(mesh.points.size());
        elements = range(mesh.hexahedra.size());
        return;
    }
    const Index number = mesh.findPart(spec.part);
    if (number < 0) {
        std::string names;
        for (const MeshPart& part : mesh.parts) names += " " + part.name;
        refuseName("part '" + spec.part + "'", names);
    }
    const MeshPart& part = mesh.parts[std::size_t(number)];
    for (Index i = 0; i < part.elementCount; ++i) {
        const Index element = part.firstElement + i;
        elements.push_back(element);
        const Hexahedron& corners = mesh.hexahedra[std::size_t(element)];
        nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
    sortUnique(nodes);
}

/// Nodes of a set, and for a side set the elements behind its sides.
void selectSet(const TableSpec& spec,
               const Mesh& mesh,
               std::vector<Index>& nodes,
               std::vector<Index>& elements)
{
    if (const auto sides = mesh.sideSets.find(spec.set); sides != mesh.sideSets.end()) {
        nodes = nodesOf(mesh, sides->second);
        for (const ElementSide& side : sides->second) elements.push_back(side.element);
        sortUnique(elements);
        return;
    }
    if (const auto found = mesh.nodeSets.find(spec.set); found != mesh.nodeSets.end()) {
        nodes = found->second;
        return;
    }
    std::string names;
    for (const auto& [name, sides] : mesh.sideSets) names += " " + name;
    for (const auto& [name, members] : mesh.nodeSets) names += " " + name;
    refuseName("set '" + spec.set + "'", names);
}

/// Leaves the one entity nearest to `position`.
template <class Place>
void keepNearest(std::vector<Index>& entities, const Point& position, const Place& place)
{
    const auto distance = [&](Index entity) {
        const Point at = place(entity);
        return std::hypot(at[0] - position[0], at[1] - position[1], at[2] - position[2]);
    };
    const auto nearest = std::min_element(entities.begin(), entities.end(), [&](Index a, Index b) {
        return distance(a) < distance(b);
    });
    if (nearest != entities.end()) entities = {*nearest};
}

} // namespace

TableProbe::TableProbe(const TableSpec& spec, const Mesh& mesh) : spec_(spec), mesh_(mesh)
{
    if (spec.set.empty())
        selectPart(spec, mesh, nodes_, elements_);
    else
        selectSet(spec, mesh, nodes_, elements_);
    if (spec.kind == TableSpec::Kind::point) {
        keepNearest(nodes_, spec.position, [&](Index node) { return place(node, true); });
        keepNearest(elements_, spec.position, [&](Index element) { return place(element, false); });
    }
}

const std::vector<Index>& TableProbe::entities(bool onNodes) const
{
    const std::vector<Index>& chosen = onNodes ? nodes_ : elements_;
    if (chosen.empty())
        throw Error(
            ExitCode::dictionary,
            "set '" + spec_.set + "' has no "
                + (onNodes ? "nodes"
                           : "elements, but field '" + spec_.field.field + "' lives on elements"),
            "name a set of element sides, or a part");
    return chosen;
}

Point TableProbe::place(Index entity, bool onNodes) const
{
    return onNodes ? mesh_.points[std::size_t(entity)] : elementCentre(mesh_, entity);
}

std::vector<double> TableProbe::extremaRow(const Frame& frame)
{
    if (table_.columns.empty())
        table_.columns = {"time", "min",   "min_x", "min_y", "min_z",
                          "max",  "max_x", "max_y", "max_z"};
    const ScalarField field = scalarField(frame, spec_.field);
    std::vector<Index> chosen = entities(field.onNodes);
    const Index any = chosen.front();
    std::erase_if(chosen, [&](Index i) { return std::isnan(field.values.at(std::size_t(i))); });
    if (chosen.empty()) chosen = {any};
    const auto lower = [&](Index a, Index b) {
        return field.values.at(std::size_t(a)) < field.values.at(std::size_t(b));
    };
    const auto [least, most] = std::minmax_element(chosen.begin(), chosen.end(), lower);
    std::vector<double> row{frame.time};
    for (const Index entity : {*least, *most}) {
        const Point at = place(entity, field.onNodes);
        row.insert(row.end(), {field.values[std::size_t(entity)], at[0], at[1], at[2]});
    }
    return row;
}

std::vector<double> TableProbe::componentRow(const Frame& frame)
{
    const auto [field, onNodes] = findField(frame, spec_.field.field);
    if (table_.columns.empty()) {
        table_.columns.push_back("time");
        for (const std::string& name : componentNames(field->columns))
            table_.columns.push_back(name.empty() ? field->name : field->name + "_" + name);
    }
    const auto operation = spec_.kind == TableSpec::Kind::sum       ? TableSpec::Operation::sum
                           : spec_.kind == TableSpec::Kind::section ? spec_.operation
                                                                    : TableSpec::Operation::mean;
    std::vector<double> row{frame.time};
    for (std::size_t component = 0; component < field->columns; ++component) {
        std::vector<double> values;
        for (const Index entity : entities(onNodes))
            values.push_back(field->values.at(std::size_t(entity) * field->columns + component));
        row.push_back(reduce(values, operation));
    }
    return row;
}

void TableProbe::sampleProfile(const Frame& frame)
{
    const auto [field, onNodes] = findField(frame, spec_.field.field);
    table_.columns = {"x", "y", "z"};
    for (const std::string& name : componentNames(field->columns))
        table_.columns.push_back(name.empty() ? field->name : field->name + "_" + name);
    table_.rows.clear();
    for (const Index entity : entities(onNodes)) {
        const Point at = place(entity, onNodes);
        std::vector<double> row{at[0], at[1], at[2]};
        for (std::size_t component = 0; component < field->columns; ++component)
            row.push_back(field->values.at(std::size_t(entity) * field->columns + component));
        table_.rows.push_back(std::move(row));
    }
    std::stable_sort(table_.rows.begin(), table_.rows.end(),
                     [&](const auto& a, const auto& b) { return a[spec_.axis] < b[spec_.axis]; });
}

void TableProbe::sample(const Frame& frame)
{
    if (spec_.kind == TableSpec::Kind::profile) return sampleProfile(frame);
    const bool extrema = spec_.kind == TableSpec::Kind::extrema;
    table_.rows.push_back(extrema ? extremaRow(frame) : componentRow(frame));
}

} // namespace fpm
