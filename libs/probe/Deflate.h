#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fpm {

/// `bytes` as a zlib stream (RFC 1950): one deflate block (RFC 1951) with fixed Huffman codes over
/// greedy LZ77 matches in a 32 KiB window. About twice the size of the best compressors' output,
/// in exchange for no dependency.
std::vector<std::uint8_t> zlibCompress(std::span<const std::uint8_t> bytes);

} // namespace fpm
