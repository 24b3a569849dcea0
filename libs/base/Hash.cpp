#include "base/Hash.h"

namespace fpm {

std::string hexText(std::uint64_t number)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text(16, '0');
    for (std::size_t digit = 0; digit < 16; ++digit)
        text[digit] = digits[(number >> (60 - 4 * digit)) & 15];
    return text;
}

} // namespace fpm
