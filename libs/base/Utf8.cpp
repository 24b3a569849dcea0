#include "base/Utf8.h"

#include <algorithm>
#include <cstdint>

namespace fpm {

namespace {

std::size_t announcedLength(unsigned char lead)
{
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    if (lead >= 0xF0 && lead < 0xF5) return 4;
    return 0;
}

/// Overlong forms, UTF-16 halves and values past U+10FFFF show in the second byte.
bool isSecondByteAllowed(unsigned char lead, unsigned char second)
{
    if (lead == 0xE0) return second >= 0xA0;
    if (lead == 0xED) return second < 0xA0;
    if (lead == 0xF0) return second >= 0x90;
    if (lead == 0xF4) return second < 0x90;
    return true;
}

bool isControl(std::string_view character)
{
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) return (first < 0x20 && first != '\t') || first == 0x7F;
    return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

} // namespace

std::size_t characterLength(std::string_view text, std::size_t offset)
{
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const auto length = announcedLength(byte(offset));
    if (length == 0 || length > text.size() - offset) return 0;
    for (std::size_t next = 1; next < length; ++next)
        if ((byte(offset + next) & 0xC0) != 0x80) return 0;
    if (length > 1 && !isSecondByteAllowed(byte(offset), byte(offset + 1))) return 0;
    return length;
}

std::size_t countCharacters(std::string_view text)
{
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++count)
        at += std::max<std::size_t>(1, characterLength(text, at));
    return count;
}

std::string printable(std::string_view text)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto length = characterLength(text, at);
        const auto character = text.substr(at, std::max<std::size_t>(1, length));
        if (length == 0 || isControl(character))
            result += '?';
        else
            result += character;
        at += character.size();
    }
    return result;
}

std::string printableLines(std::string_view text)
{
    std::string result;
    for (;;) {
        const auto end = text.find('\n');
        result += printable(text.substr(0, end));
        if (end == text.npos) return result;
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t longest = 60;
    std::size_t at = 0;
    for (std::size_t count = 0; at < text.size() && count < longest; ++count)
        at += std::max<std::size_t>(1, characterLength(text, at));
    return printable(text.substr(0, at)) + (at < text.size() ? "..." : "");
}

} // namespace fpm
