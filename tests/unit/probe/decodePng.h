#pragma once

#include "probe/Png.h"

#include <cstdlib>
#include <stdexcept>

namespace fpm::test {

/// Reads what zlibCompress writes: one block with fixed Huffman codes (RFC 1951 3.2.6).
class FixedInflate
{
public:
    explicit FixedInflate(std::span<const std::uint8_t> stream) : stream_(stream.subspan(2)) {}

    std::vector<std::uint8_t> bytes()
    {
        if (bits(1) != 1 || bits(2) != 1) throw std::runtime_error("not one fixed block");
        for (unsigned symbol = literal(); symbol != 256; symbol = literal()) {
            if (symbol < 256)
                out_.push_back(std::uint8_t(symbol));
            else
                copy(symbol);
        }
        return out_;
    }

private:
    unsigned bits(int count) // least significant first
    {
        unsigned value = 0;
        for (int bit = 0; bit < count; ++bit, ++at_)
            value |= unsigned(stream_[at_ / 8] >> (at_ % 8) & 1) << bit;
        return value;
    }
    unsigned code(int count) // Huffman: most significant first
    {
        unsigned value = 0;
        for (int bit = 0; bit < count; ++bit) value = value << 1 | bits(1);
        return value;
    }
    unsigned literal()
    {
        unsigned value = code(7);
        if (value <= 23) return 256 + value;
        value = value << 1 | code(1);
        if (value >= 48 && value <= 191) return value - 48;
        if (value >= 192 && value <= 199) return 280 + value - 192;
        return 144 + (value << 1 | code(1)) - 400;
    }
    void copy(unsigned symbol)
    {
        static constexpr int lengthBase[] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
        static constexpr int distanceBase[] = {
            1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
            193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
        const int s = int(symbol) - 257;
        const int length = lengthBase[s] + int(bits(s < 8 || s == 28 ? 0 : (s - 4) / 4));
        const int d = int(code(5));
        const int distance = distanceBase[d] + int(bits(d < 4 ? 0 : (d - 2) / 2));
        for (int i = 0; i < length; ++i)
            out_.push_back(out_.at(out_.size() - std::size_t(distance)));
    }

    std::span<const std::uint8_t> stream_;
    std::size_t at_ = 0;
    std::vector<std::uint8_t> out_;
};

inline std::uint32_t bigEndian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16
           | std::uint32_t(bytes[at + 2]) << 8 | bytes[at + 3];
}

/// Reads what encodePng writes: signature, IHDR, one IDAT, IEND.
inline Image decodePng(std::span<const std::uint8_t> file)
{
    Image image{int(bigEndian(file, 16)), int(bigEndian(file, 20)), {}};
    const auto raw = FixedInflate(file.subspan(41, bigEndian(file, 33))).bytes();
    const std::size_t row = 3 * std::size_t(image.width);
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
