#pragma once

#include "probe/Svg.h"
#include "probe/SvgPlot.h"

#include <string>
#include <vector>

namespace fpm {

/// A mark of a plot, in pixels.
struct PlacedMark {
    PlotMark mark;
    Pixel at;
    double barFrom, barTo;
    std::string colour;
};

/// Draws marks and the texts beside them; each text takes the first place around its mark, within
/// the frame, that covers neither a mark nor another text.
void drawMarks(SvgDrawing& svg, std::vector<PlacedMark> marks, Pixel upperLeft, Pixel lowerRight);

} // namespace fpm
