#pragma once

#include "base/Types.h"
#include "probe/ColourMap.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fpm {

/// What stands around a picture.
struct PictureNotes {
    std::string title, subtitle;
    std::string quantity; ///< heading of the colour bar
    ColourScale scale;
    double smallest = 0, largest = 0;                       ///< in this picture, below the bar
    std::vector<std::pair<std::string, Colour>> categories; ///< instead of a bar where not empty
    std::array<Point, 3> axes{};                            ///< x y z as right, up, towards the eye
};

/// An SVG of the picture with vector text: title above; colour bar and axes to the right, so that
/// nothing ever lies over the model. `width` and `height` are those of the picture on the page.
std::string pictureSheet(std::span<const std::uint8_t> png,
                         double width,
                         double height,
                         const PictureNotes& notes);

} // namespace fpm
