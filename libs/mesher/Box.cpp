#include "base/Format.h"
#include "mesher/Shape.h"
#include "mesher/Stations.h"

#include <array>
#include <cmath>

namespace fpm {

namespace {

struct Block {
    std::array<int, 3> cells;
    Point grading;
    std::int64_t cellCount;
};

/// The grading that keeps the stations of the unrefined row among those of the refined one.
double refinedGrading(double grading, int cells, int refinement)
{
    if (cells == 1) return 1;
    return std::pow(grading, (double(cells) * refinement - 1) / (double(cells - 1) * refinement));
}

Block readBlock(const Dictionary& entry, int refinement)
{
    constexpr double mostGrading = 1e6;
    Block block{readCells(entry, "cells"), entry.vectorOr("grading", {1, 1, 1}), 1};
    for (const double ratio : block.grading)
        if (!(ratio >= 1 / mostGrading && ratio <= mostGrading))
            entry.fail(
                "grading",
                format("'grading' must be three numbers between 1e-06 and 1e+06, found {}", ratio));
    for (int k = 0; k < 3; ++k) {
        if (refinement > 1)
            block.grading[k] = refinedGrading(block.grading[k], block.cells[k], refinement);
        block.cells[k] = refined(entry, "cells", block.cells[k], refinement, maxCellsInRow);
        block.cellCount *= block.cells[k];
    }
    requireCountable(entry, "cells", block.cellCount);
    return block;
}

Point readSize(const Dictionary& entry)
{
    const Point size = entry.vector("size");
    for (const double length : size)
        if (!(length > 0))
            entry.fail("size", format("'size' must be three numbers > 0, found {}", length));
    return size;
}

Shape boxShape(const std::string& name,
               const Dictionary& entry,
               const Block& block,
               const Point& low,
               const Point& high)
{
    Shape shape;
    shape.name = name;
    shape.subject = entry.name();
    shape.section = squareSection(block.cells[0], block.cells[1]);
    shape.layers = block.cells[2];
    shape.cellCount = block.cellCount;
    shape.faces = {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

    std::array<std::vector<double>, 3> places;
    for (int k = 0; k < 3; ++k)
        places[k] = stations(low[k], high[k], block.cells[k], block.grading[k]);
    shape.place = [places, cells = block.cells](const Point& reference) {
        PlacedNode node;
        for (int k = 0; k < 3; ++k) {
            const int station = stationOf(reference[k], cells[k]);
            node.position[k] = places[k][station];
            node.faces |= unsigned(station == 0) << (2 * k);
            node.faces |= unsigned(station == cells[k]) << (2 * k + 1);
        }
        return node;
    };
    shape.axes = [](const Point&) -> std::array<Point, 3> {
        return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    };
    return shape;
}

} // namespace

Shape readBox(const std::string& name, const Dictionary& entry, int refinement)
{
    const Point origin = entry.vector("origin"), size = readSize(entry);
    return boxShape(name, entry, readBlock(entry, refinement), origin,
                    {origin[0] + size[0], origin[1] + size[1], origin[2] + size[2]});
}

std::vector<Shape> readLayers(const std::string& name, const Dictionary& entry, int refinement)
{
    constexpr int mostLayers = 1000;
    const Point origin = entry.vector("origin"), size = readSize(entry);
    const int count = int(entry.integer("count", 1, mostLayers));
    const Block block = readBlock(entry, refinement);
    requireCountable(entry, "count", count * block.cellCount);
    // One list of heights for all: the top of a layer and the bottom of the next are the same
    // number.
    const auto heights = stations(origin[2], origin[2] + size[2], count);
    std::vector<Shape> shapes;
    for (int layer = 0; layer < count; ++layer)
        shapes.push_back(boxShape(name + std::to_string(layer + 1), entry, block,
                                  {origin[0], origin[1], heights[layer]},
                                  {origin[0] + size[0], origin[1] + size[1], heights[layer + 1]}));
    return shapes;
}

} // namespace fpm
