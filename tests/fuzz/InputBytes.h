#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fpm::fuzz {

/// Takes the bytes of a fuzzer's input one after the other; zeros follow its end.
class InputBytes
{
public:
    InputBytes(const unsigned char* bytes, std::size_t size) : next_(bytes), end_(bytes + size) {}
    bool isEmpty() const { return next_ == end_; }
    std::uint8_t byte() { return isEmpty() ? 0 : *next_++; }
    /// From so many bytes.
    std::uint64_t number(int count)
    {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) value = value << 8 | byte();
        return value;
    }
    /// A number below `limit`, which is not 0.
    std::size_t below(std::size_t limit) { return std::size_t(number(3)) % limit; }
    std::string text(std::size_t most)
    {
        std::string text;
        while (!isEmpty() && text.size() < most) text += char(byte());
        return text;
    }

private:
    const unsigned char *next_, *end_;
};

} // namespace fpm::fuzz
