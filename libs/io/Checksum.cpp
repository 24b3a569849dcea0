#include "io/Checksum.h"

#include "base/Hash.h"

#include <cstring>

namespace fpm {
namespace {

/// Invertible in both arguments (odd factor, xor with a shifted copy): no single word is lost.
std::uint64_t mixed(std::uint64_t state, std::uint64_t word)
{
    state = (state ^ word) * 0xff51afd7ed558ccdU;
    return state ^ (state >> 32);
}

} // namespace

void Checksum::add(std::span<const std::byte> bytes)
{
    std::size_t next = 0;
    const auto addByte = [&] {
        pending_ |= std::uint64_t(bytes[next++]) << (8 * (length_++ % 8));
        if (length_ % 8 == 0) {
            state_ = mixed(state_, pending_);
            pending_ = 0;
        }
    };
    while (next < bytes.size() && length_ % 8 != 0) addByte();
    for (; next + 8 <= bytes.size(); next += 8, length_ += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + next, 8);
        state_ = mixed(state_, word);
    }
    while (next < bytes.size()) addByte();
}

void Checksum::add(std::string_view text)
{
    addNumber(text.size());
    add(std::as_bytes(std::span(text)));
}

void Checksum::addNumber(std::uint64_t number)
{
    add(std::as_bytes(std::span(&number, 1)));
}

std::uint64_t Checksum::value() const
{
    return mixed(mixed(mixed(state_, pending_), length_), 0);
}

std::string Checksum::text() const
{
    return hexText(value());
}

} // namespace fpm
