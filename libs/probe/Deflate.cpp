#include "probe/Deflate.h"

#include <algorithm>
#include <array>

namespace fpm {

namespace {

constexpr std::size_t window = 32768, longest = 258, shortest = 3;
constexpr int chainLimit = 24;      ///< candidates tried at a position
constexpr std::size_t enough = 128; ///< a match so long ends the search

/// Bits in deflate's order: least significant first.
class BitWriter
{
public:
    explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    void put(std::uint32_t bits, int count)
    {
        held_ |= std::uint64_t(bits) << count_;
        for (count_ += count; count_ >= 8; count_ -= 8, held_ >>= 8)
            bytes_.push_back(std::uint8_t(held_));
    }
    void putCode(std::uint32_t code, int count) // Huffman codes go most significant bit first
    {
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < count; ++bit) reversed |= ((code >> bit) & 1u) << (count - 1 - bit);
        put(reversed, count);
    }
    void finish()
    {
        if (count_ > 0) put(0, 8 - count_);
    }

private:
    std::vector<std::uint8_t>& bytes_;
    std::uint64_t held_ = 0;
    int count_ = 0;
};

/// Literal/length code, RFC 1951 3.2.6.
void putSymbol(BitWriter& out, std::uint32_t symbol)
{
    if (symbol < 144)
        out.putCode(0x30 + symbol, 8);
    else if (symbol < 256)
        out.putCode(0x190 + symbol - 144, 9);
    else if (symbol < 280)
        out.putCode(symbol - 256, 7);
    else
        out.putCode(0xC0 + symbol - 280, 8);
}

/// A length (3..258) or distance (1..32768) falls in a class with some extra bits: RFC 1951 3.2.5.
struct ExtraBits {
    std::uint32_t symbol, bits;
    int count;
};

ExtraBits classify(std::uint32_t offset, int subdivisionBits)
{
    int count = 0;
    while ((offset >> count) >= (2u << subdivisionBits)) ++count;
    const std::uint32_t perClass = 1u << subdivisionBits;
    return {std::uint32_t(count) * perClass + (offset >> count), offset & ((1u << count) - 1),
            count};
}

void putMatch(BitWriter& out, std::size_t length, std::size_t distance)
{
    if (length == longest) {
        putSymbol(out, 285);
    } else {
        const ExtraBits code = classify(std::uint32_t(length - shortest), 2);
        putSymbol(out, 257 + code.symbol);
        out.put(code.bits, code.count);
    }
    const ExtraBits code = classify(std::uint32_t(distance - 1), 1);
    out.putCode(code.symbol, 5);
    out.put(code.bits, code.count);
}

/// Earlier positions with the same next three bytes, newest first.
class MatchFinder
{
public:
    explicit MatchFinder(std::span<const std::uint8_t> bytes)
        : bytes_(bytes),
          newest_(hashSize, -1),
          previous_(window, -1)
    {
    }
    void insert(std::size_t at)
    {
        if (at + shortest > bytes_.size()) return;
        std::int64_t& head = newest_[hash(at)];
        previous_[at % window] = head;
        head = std::int64_t(at);
    }
    /// Longest match for what starts at `at`: {length, distance}; length 0 when none.
    std::array<std::size_t, 2> find(std::size_t at) const
    {
        std::array<std::size_t, 2> best{0, 0};
        if (at + shortest > bytes_.size()) return best;
        const std::size_t limit = std::min(longest, bytes_.size() - at);
        std::int64_t candidate = newest_[hash(at)];
        for (int tries = 0; tries < chainLimit && candidate >= 0; ++tries) {
            const std::size_t distance = at - std::size_t(candidate);
            if (distance > window - 1) break;
            std::size_t length = 0;
            const std::uint8_t* old = &bytes_[std::size_t(candidate)];
            while (length < limit && old[length] == bytes_[at + length]) ++length;
            if (length >= shortest && length > best[0]) best = {length, distance};
            if (best[0] >= std::min(limit, enough)) break;
            const std::int64_t older = previous_[std::size_t(candidate) % window];
            if (older >= candidate) break; // slot reused by a newer position
            candidate = older;
        }
        return best;
    }

private:
    static constexpr std::size_t hashSize = 1 << 15;
    std::size_t hash(std::size_t at) const
    {
        const std::uint32_t key = std::uint32_t(bytes_[at]) | std::uint32_t(bytes_[at + 1]) << 8
                                  | std::uint32_t(bytes_[at + 2]) << 16;
        return (key * 2654435761u) >> 17;
    }
    std::span<const std::uint8_t> bytes_;
    std::vector<std::int64_t> newest_, previous_;
};

std::uint32_t adler32(std::span<const std::uint8_t> bytes)
{
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

} // namespace

std::vector<std::uint8_t> zlibCompress(std::span<const std::uint8_t> bytes)
{
    std::vector<std::uint8_t> result{0x78, 0x01};
    result.reserve(bytes.size() / 4 + 64);
    BitWriter out(result);
    out.put(1, 1); // last block
    out.put(1, 2); // fixed Huffman codes
    MatchFinder finder(bytes);
    for (std::size_t at = 0; at < bytes.size();) {
        const auto [length, distance] = finder.find(at);
        if (length == 0)
            putSymbol(out, bytes[at]);
        else
            putMatch(out, length, distance);
        for (const std::size_t next = at + std::max<std::size_t>(1, length); at < next; ++at)
            finder.insert(at);
    }
    putSymbol(out, 256);
    out.finish();
    const std::uint32_t check = adler32(bytes);
    for (int shift = 24; shift >= 0; shift -= 8) result.push_back(std::uint8_t(check >> shift));
    return result;
}

} // namespace fpm
