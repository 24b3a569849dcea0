#include "dictionary/Report.h"

#include "base/Utf8.h"

#include <algorithm>

namespace fpm {

namespace {

/// The part of a line that is shown, and where in it the marked text lies (bytes of the source).
struct Window {
    std::size_t begin, end;
    bool isCutBefore, isCutAfter;
};

bool isContinuation(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

Window windowAround(std::string_view text, std::size_t offset)
{
    constexpr std::size_t reach = 80;
    const auto before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    const std::size_t lineBegin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t lineEnd = std::min(text.find('\n', offset), text.size());

    std::size_t begin = lineBegin, end = lineEnd;
    if (offset - begin > reach) begin = offset - reach;
    if (end - offset > reach) end = offset + reach;
    while (begin > lineBegin && begin < offset && isContinuation(text[begin])) ++begin;
    while (end < lineEnd && end > offset && isContinuation(text[end])) --end;
    return {begin, end, begin > lineBegin, end < lineEnd};
}

/// Blanks as wide as `text`; a tab stays one, so that the caret lies under its character.
std::string blanksFor(std::string_view text)
{
    std::string blanks;
    for (const char character : printable(text))
        if (!isContinuation(character)) blanks += character == '\t' ? '\t' : ' ';
    return blanks;
}

std::string heading(const std::string& message,
                    const std::string& margin,
                    const std::string& place,
                    const std::string& path)
{
    return message + '\n' + margin + "--> " + place + (path.empty() ? "" : ", in " + path);
}

std::string note(const std::string& margin, const std::string& text)
{
    return text.empty() ? "" : '\n' + margin + " = " + text;
}

} // namespace

LineAndColumn lineAndColumn(std::string_view text, std::size_t offset)
{
    const auto before = text.substr(0, offset);
    const auto lineBegin = before.rfind('\n') + 1; // npos + 1 is 0
    const auto lines = std::count(before.begin(), before.end(), '\n');
    return {static_cast<std::size_t>(lines) + 1, countCharacters(before.substr(lineBegin)) + 1};
}

std::string report(const Document& document,
                   const Token& at,
                   const std::string& path,
                   const std::string& message,
                   const std::string& advice)
{
    const auto& source = document.files[at.file];
    const std::string_view text = source.text;
    const auto window = windowAround(text, at.offset);
    const auto shown = text.substr(window.begin, window.end - window.begin);
    const auto marked =
        text.substr(at.offset, std::min<std::size_t>(at.length, window.end - at.offset));
    const std::string cut = window.isCutBefore ? "..." : "";

    auto number = std::to_string(lineAndColumn(text, at.offset).line);
    number.insert(0, number.size() < 2 ? 1 : 0, ' ');
    const std::string margin(number.size(), ' ');

    const auto line = cut + printable(shown) + (window.isCutAfter ? "..." : "");
    const auto carets = std::string(cut.size(), ' ')
                        + blanksFor(shown.substr(0, at.offset - window.begin))
                        + std::string(std::max<std::size_t>(1, countCharacters(marked)), '^');

    auto result = heading(message, margin, document.place(at), path);
    result += '\n' + margin + " |\n" + number + (line.empty() ? " |" : " | ") + line + '\n';
    result += margin + " | " + carets;
    result += note(margin, advice);
    if (source.includedFrom)
        result += note(margin, "included at " + document.place(*source.includedFrom));
    return result;
}

std::string report(const std::string& file,
                   const std::string& path,
                   const std::string& message,
                   const std::string& advice)
{
    const std::string margin(2, ' ');
    return heading(message, margin, file, path) + note(margin, advice);
}

} // namespace fpm
