#include "mesher/MeshReport.h"

#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/SmallElements.h"
#include "mesh/Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace fpm {

namespace {

constexpr std::size_t nameWidth = 20, numberWidth = 12;
constexpr int digits = 5;
constexpr double missingAtMost = 0.005; ///< of a round section, without a word

std::string row(std::string name, const std::array<std::string, 7>& cells)
{
    name.resize(std::max(nameWidth, name.size() + 1), ' ');
    for (const auto& cell : cells) {
        name.append(cell.size() < numberWidth ? numberWidth - cell.size() : 1, ' ');
        name += cell;
    }
    return name;
}

std::string nameOf(const Mesh& body)
{
    std::string names;
    for (const auto& part : body.parts) names += (names.empty() ? "" : " ") + part.name;
    return names;
}

} // namespace

MeshReport::MeshReport(Log& log)
    : log_(log),
      minScaledJacobian_(std::numeric_limits<double>::infinity()),
      minHeight_(std::numeric_limits<double>::infinity())
{
    log_.line(row("body", {"elements", "nodes", "Jacobian min", "median", "edge ratio",
                           "min height", "volume"}));
}

void MeshReport::add(const Mesh& body, double roundVolume)
{
    const Quality figures = quality(body);
    log_.line(
        row(nameOf(body),
            {toText(body.hexahedra.size()), toText(body.points.size()),
             toText(figures.minScaledJacobian, digits),
             toText(figures.medianScaledJacobian, digits), toText(figures.maxEdgeRatio, digits),
             toText(figures.minHeight, digits), toText(figures.totalVolume, digits)}));
    const double missing = roundVolume > 0 ? 1 - figures.totalVolume / roundVolume : 0;
    if (missing > missingAtMost)
        notes_.push_back(format(
            "{}: its chords lack {} % of the round section, and so of mass and stiffness: more "
            "cells around, or {} times the radius for the same area",
            nameOf(body), toText(100 * missing, 3), toText(1 / std::sqrt(1 - missing), 5)));
    ++bodies_;
    elements_ += body.hexahedra.size();
    nodes_ += body.points.size();
    minScaledJacobian_ = std::min(minScaledJacobian_, figures.minScaledJacobian);
    minHeight_ = std::min(minHeight_, figures.minHeight);
    maxEdgeRatio_ = std::max(maxEdgeRatio_, figures.maxEdgeRatio);
    volume_ += figures.totalVolume;
}

void MeshReport::total()
{
    log_.line(
        row(format("total, {} {}", bodies_, bodies_ == 1 ? "body" : "bodies"),
            {toText(elements_), toText(nodes_), toText(minScaledJacobian_, digits), "",
             toText(maxEdgeRatio_, digits), toText(minHeight_, digits), toText(volume_, digits)}));
    for (const std::string& note : notes_) log_.line(note);
}

void reportInnerSides(const Mesh& mesh, Log& log)
{
    for (const auto& [name, sides] : mesh.sideSets) {
        const std::size_t inner = innerSides(mesh, sides).size();
        if (inner > 0)
            log.line(format("set {}: {} of its {} sides lie inside the material, between elements "
                            "that share the nodes: no place for a pressure, a traction or contact",
                            name, inner, sides.size()));
    }
}

void reportSmallElements(const Mesh& mesh, Log& log)
{
    const auto few = smallElements(mesh, elementHeights(mesh));
    if (!few) return;
    log.line(
        format("{} are down to {} high, most elements {}: with equal materials they alone make "
               "the time step {} times smaller; larger elements there, or massScaling, save "
               "steps (fpmExplicit -dryRun states the cost)",
               smallElementsText(*few), toText(few->least, 3), toText(few->ordinary, 3),
               toText(few->ratio(), 3)));
}

} // namespace fpm
