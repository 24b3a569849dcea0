#pragma once

#include "probe/Svg.h"
#include "probe/SvgPlot.h"

#include <string>
#include <vector>

namespace fpm {

/// Height of the line of a mark whose y is not known.
inline constexpr double unknownLine = 16;

/// A mark of a plot, in pixels.
struct PlacedMark {
    PlotMark mark;
    Pixel at;
    double barFrom, barTo;
    std::string colour;
};

/// A piece of a curve, in pixels.
struct Stroke {
    Pixel from, to;
};

/// Draws marks (those without y one below the other from the top) and the texts beside them; each
/// text takes the place around its mark, within the frame, where least of a mark, another text or
/// a curve is covered and no other mark is as near.
void drawMarks(SvgDrawing& svg,
               std::vector<PlacedMark> marks,
               const std::vector<Stroke>& curves,
               Pixel upperLeft,
               Pixel lowerRight);

} // namespace fpm
