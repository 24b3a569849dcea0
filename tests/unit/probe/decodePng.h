#pragma once

#include "probe/Png.h"

#include <zlib.h>

#include <cstdlib>
#include <stdexcept>

namespace fpm::test {

inline std::vector<std::uint8_t> inflated(std::span<const std::uint8_t> stream, std::size_t size)
{
    std::vector<std::uint8_t> out(size);
    uLongf length = uLongf(size);
    if (uncompress(out.data(), &length, stream.data(), uLong(stream.size())) != Z_OK
        || length != size)
        throw std::runtime_error("not a zlib stream of the size of the picture");
    return out;
}

inline std::uint32_t bigEndian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16
           | std::uint32_t(bytes[at + 2]) << 8 | bytes[at + 3];
}

/// Reads what encodePng writes: signature, IHDR, one IDAT, IEND.
inline Image decodePng(std::span<const std::uint8_t> file)
{
    Image image{int(bigEndian(file, 16)), int(bigEndian(file, 20)), {}};
    const std::size_t row = 3 * std::size_t(image.width);
    const auto raw =
        inflated(file.subspan(41, bigEndian(file, 33)), (row + 1) * std::size_t(image.height));
    std::vector<std::uint8_t> pixels(row * std::size_t(image.height));
    for (std::size_t y = 0; y < std::size_t(image.height); ++y) {
        const int filter = raw[y * (row + 1)];
        for (std::size_t i = 0; i < row; ++i) {
            const int left = i < 3 ? 0 : pixels[y * row + i - 3];
            const int above = y == 0 ? 0 : pixels[(y - 1) * row + i];
            const int corner = y == 0 || i < 3 ? 0 : pixels[(y - 1) * row + i - 3];
            const int guess = left + above - corner;
            const int l = std::abs(guess - left), a = std::abs(guess - above);
            const int c = std::abs(guess - corner);
            const int nearest = l <= a && l <= c ? left : a <= c ? above : corner;
            const int predicted[] = {0, left, above, (left + above) / 2, nearest};
            pixels[y * row + i] = std::uint8_t(raw[y * (row + 1) + 1 + i] + predicted[filter]);
        }
    }
    for (std::size_t i = 0; i < pixels.size(); i += 3)
        image.pixels.push_back({pixels[i], pixels[i + 1], pixels[i + 2]});
    return image;
}

} // namespace fpm::test
