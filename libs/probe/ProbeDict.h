#pragma once

#include "case/Case.h"
#include "probe/Picture.h"
#include "probe/SvgPlot.h"
#include "probe/TableProbe.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fpm {

/// A curve of a plot and the table it is read from.
struct SeriesSpec {
    std::string name, label;
    std::string file; ///< as written, relative to the case
    std::filesystem::path path;
    std::string xColumn, yColumn;
    double xScale = 1, yScale = 1;   ///< factors on the columns
    double xOffset = 0, yOffset = 0; ///< added after scaling
    SeriesStyle style = SeriesStyle::line;
};

/// system/probeDict, plots: one entry.
struct PlotSpec {
    std::string name, title;
    PlotAxis x, y;
    std::vector<SeriesSpec> series;
};

/// All of system/probeDict.
struct ProbeDict {
    std::vector<TableSpec> tables;
    std::vector<PictureSpec> pictures;
    std::vector<PlotSpec> plots;
};

/// Reads and checks every entry before anything is made. Throws InputError.
ProbeDict readProbeDict(const Dictionary& dictionary, const Case& theCase);

} // namespace fpm
