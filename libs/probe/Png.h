#pragma once

#include "probe/ColourMap.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fpm {

/// Pixels row by row from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;
};

/// A PNG file (ISO/IEC 15948): 8-bit RGB, best of the five row filters.
std::vector<std::uint8_t> encodePng(const Image& image);
/// Adds a comment (chunk tEXt, Latin-1) behind the header of a PNG file.
void addComment(std::vector<std::uint8_t>& png, std::string_view text);
/// RFC 4648, for data URIs.
std::string base64(std::span<const std::uint8_t> bytes);

} // namespace fpm
