#include "probe/Png.h"

#include "base/Error.h"

#include <zlib.h>

#include <cstdlib>
#include <string_view>

namespace fpm {

namespace {

using Bytes = std::vector<std::uint8_t>;

void putNumber(Bytes& bytes, std::uint32_t number)
{
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(number >> shift));
}

void putChunk(Bytes& file, std::string_view type, std::span<const std::uint8_t> content)
{
    putNumber(file, std::uint32_t(content.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), content.begin(), content.end());
    putNumber(file, std::uint32_t(crc32_z(0, file.data() + begin, file.size() - begin)));
}

/// A zlib stream (RFC 1950).
Bytes compressed(std::span<const std::uint8_t> bytes)
{
    uLongf size = compressBound(uLong(bytes.size()));
    Bytes stream(size);
    const int code =
        compress2(stream.data(), &size, bytes.data(), uLong(bytes.size()), Z_DEFAULT_COMPRESSION);
    if (code != Z_OK) throw Error(ExitCode::memory, "no memory to compress a picture");
    stream.resize(size);
    return stream;
}

int paeth(int left, int above, int corner)
{
    const int guess = left + above - corner;
    const int l = std::abs(guess - left), a = std::abs(guess - above), c = std::abs(guess - corner);
    return l <= a && l <= c ? left : a <= c ? above : corner;
}

/// What row filter 0..4 predicts for a byte from its three neighbours.
int prediction(int filter, int left, int above, int corner)
{
    switch (filter) {
    case 1:
        return left;
    case 2:
        return above;
    case 3:
        return (left + above) / 2;
    case 4:
        return paeth(left, above, corner);
    default:
        return 0;
    }
}

/// Appends the row under the filter with the smallest sum of absolute differences.
void putRow(Bytes& out, std::span<const std::uint8_t> row, std::span<const std::uint8_t> above)
{
    constexpr std::size_t pixel = 3;
    Bytes best, trial(row.size());
    long bestCost = 0;
    int bestFilter = 0;
    for (int filter = 0; filter < 5; ++filter) {
        long cost = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int left = i < pixel ? 0 : row[i - pixel], up = above[i];
            const int corner = i < pixel ? 0 : above[i - pixel];
            trial[i] = std::uint8_t(row[i] - prediction(filter, left, up, corner));
            cost += std::abs(int(std::int8_t(trial[i])));
        }
        if (filter == 0 || cost < bestCost) best = trial, bestCost = cost, bestFilter = filter;
    }
    out.push_back(std::uint8_t(bestFilter));
    out.insert(out.end(), best.begin(), best.end());
}

} // namespace

std::vector<std::uint8_t> encodePng(const Image& image)
{
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    Bytes header;
    putNumber(header, std::uint32_t(image.width));
    putNumber(header, std::uint32_t(image.height));
    header.insert(header.end(), {8, 2, 0, 0, 0}); // 8 bits, RGB, deflate, filters, not interlaced
    putChunk(file, "IHDR", header);

    const std::size_t rowBytes = 3 * std::size_t(image.width);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
    const Bytes blank(rowBytes, 0);
    Bytes filtered;
    filtered.reserve((rowBytes + 1) * std::size_t(image.height));
    for (std::size_t row = 0; row < std::size_t(image.height); ++row) {
        const std::uint8_t* start = bytes + row * rowBytes;
        putRow(filtered, {start, rowBytes}, {row == 0 ? blank.data() : start - rowBytes, rowBytes});
    }
    putChunk(file, "IDAT", compressed(filtered));
    putChunk(file, "IEND", {});
    return file;
}

void addComment(std::vector<std::uint8_t>& png, std::string_view text)
{
    constexpr std::string_view keyword("Comment\0", 8);
    constexpr std::ptrdiff_t headerEnd = 8 + 12 + 13; // signature, chunk IHDR
    Bytes content(keyword.begin(), keyword.end()), chunk;
    content.insert(content.end(), text.begin(), text.end());
    content.push_back('\n'); // or the checksum behind it would seem to go on with the text
    putChunk(chunk, "tEXt", content);
    png.insert(png.begin() + headerEnd, chunk.begin(), chunk.end());
}

std::string base64(std::span<const std::uint8_t> bytes)
{
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const std::uint32_t triple = std::uint32_t(bytes[i]) << 16
                                     | (left > 1 ? std::uint32_t(bytes[i + 1]) << 8 : 0)
                                     | (left > 2 ? bytes[i + 2] : 0u);
        text += digits[triple >> 18];
        text += digits[triple >> 12 & 63];
        text += left > 1 ? digits[triple >> 6 & 63] : '=';
        text += left > 2 ? digits[triple & 63] : '=';
    }
    return text;
}

} // namespace fpm
