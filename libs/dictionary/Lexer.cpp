#include "dictionary/Lexer.h"

#include "base/Format.h"
#include "base/Utf8.h"
#include "dictionary/Limits.h"
#include "dictionary/Number.h"

#include <algorithm>

namespace fpm {

namespace {

constexpr std::string_view blanks = " \t\n\v\f";

bool isDigit(char character)
{
    return character >= '0' && character <= '9';
}

bool isLetter(char character)
{
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

bool opensNumber(char character)
{
    return isDigit(character) || character == '-' || character == '+' || character == '.';
}

/// What a person takes for one number, right or wrong: up to a blank, bracket, semicolon, ....
bool isNumberLike(char character)
{
    return isLetter(character) || opensNumber(character) || character == ',' || character == '_';
}

template <class Predicate>
std::size_t endOfRun(std::string_view text, std::size_t at, Predicate isPart)
{
    while (at < text.size() && isPart(text[at])) ++at;
    return at;
}

std::string numberAdvice(std::string_view text)
{
    const bool isNegative = text.starts_with('-');
    const auto size = text.substr(isNegative ? 1 : 0);
    if (text.find(',') != text.npos)
        return "the decimal point is '.'; list items are separated by blanks";
    if (size.starts_with("0x") || size.starts_with("0X"))
        return "write the number with decimal digits";
    if (text.starts_with('+') && isNumber(text.substr(1)))
        return format("write {}", text.substr(1));
    const bool hasUnit = std::any_of(text.begin(), text.end(), [](char character) {
        return isLetter(character) && character != 'e' && character != 'E';
    });
    if (isDigit(text[0]) && hasUnit)
        return "numbers carry no units and words start with a letter: put a space or quotes";
    return "a number is written 12, -0.5 or 1.5e-3";
}

std::string characterAdvice(char character)
{
    switch (character) {
    case '[':
        return "dimensions are not used here; write the number in the case's units";
    case '/':
        return "put a text with '/' in \"quotes\"";
    case '`':
        return "a case runs no commands";
    case '=':
        return "an entry is written 'keyword value;'";
    case ',':
        return "list items are separated by blanks, the decimal point is '.'";
    case '\'':
        return "strings are written in \"double quotes\"";
    case ']':
        return "";
    default:
        return "put a text with such characters in \"quotes\"";
    }
}

} // namespace

bool isWordStart(char character)
{
    return isLetter(character) || character == '_';
}

bool isWordPart(char character)
{
    return isWordStart(character) || isDigit(character) || character == '.' || character == ':'
           || character == '-';
}

Lexer::Lexer(const Document& document, std::uint16_t file)
    : text_(document.files[file].text),
      file_(file)
{
    next_ = tokenAt(blankEnd(0));
}

Token Lexer::take()
{
    const Token taken = next_;
    next_ = tokenAt(blankEnd(taken.offset + taken.length));
    return taken;
}

std::size_t Lexer::blankEnd(std::size_t at) const
{
    for (;;) {
        at = std::min(text_.find_first_not_of(blanks, at), text_.size());
        const auto end = commentEnd(at);
        if (end == at) return at;
        at = end;
    }
}

std::size_t Lexer::commentEnd(std::size_t at) const
{
    const auto opening = text_.substr(at, 2);
    if (opening == "//") return std::min(text_.find('\n', at), text_.size());
    if (opening != "/*") return at;
    const auto closing = text_.find("*/", at + 2);
    if (closing == text_.npos)
        throw Fault{run(TokenKind::word, at, at + 2), "this comment is never closed",
                    "close it with */"};
    return closing + 2;
}

Token Lexer::tokenAt(std::size_t at) const
{
    if (at == text_.size()) return run(TokenKind::end, at, at);
    const char first = text_[at];
    switch (first) {
    case '{':
        return run(TokenKind::openBrace, at, at + 1);
    case '}':
        return run(TokenKind::closeBrace, at, at + 1);
    case '(':
        return run(TokenKind::openBracket, at, at + 1);
    case ')':
        return run(TokenKind::closeBracket, at, at + 1);
    case ';':
        return run(TokenKind::semicolon, at, at + 1);
    case '"':
        return string(at);
    case '$':
        return macro(at);
    case '#': {
        const auto end = endOfRun(text_, at + 1, isLetter);
        return run(TokenKind::directive, at, std::max(end, std::min(at + 2, text_.size())));
    }
    default:
        break;
    }
    if (isWordStart(first)) return run(TokenKind::word, at, endOfRun(text_, at, isWordPart));
    if (opensNumber(first)) return number(at);
    refuseCharacter(at);
}

Token Lexer::string(std::size_t at) const
{
    const auto end = text_.find_first_of("\"\n\\", at + 1);
    if (end == text_.npos || text_[end] == '\n')
        throw Fault{run(TokenKind::string, at, at + 1), "this string is not closed on its line",
                    "close it with \""};
    if (text_[end] == '\\')
        throw Fault{run(TokenKind::string, end, end + 1), "a string holds no backslash",
                    "leave out inner quotes; separate folders with '/'"};

    const auto token = run(TokenKind::string, at, end + 1);
    const auto content = text_.substr(at, token.length);
    if (printable(content) != content)
        throw Fault{token, "this string holds control characters", "delete them"};
    return token;
}

Token Lexer::macro(std::size_t at) const
{
    std::size_t begin = at + 1;
    if (begin < text_.size() && text_[begin] == ':') ++begin;
    const auto end = endOfRun(text_, begin, isWordPart);
    if (end > begin && isWordStart(text_[begin])) return run(TokenKind::macro, at, end);
    throw Fault{run(TokenKind::macro, at, std::max(end, std::min(at + 2, text_.size()))),
                "'$' must be followed by the name of an entry",
                "write $name, or $:dictionary.name from the top of the file; "
                "${...}, $.. and environment variables are not read"};
}

Token Lexer::number(std::size_t at) const
{
    const auto token = run(TokenKind::number, at, endOfRun(text_, at, isNumberLike));
    const auto content = text_.substr(at, token.length);
    if (isNumber(content)) return token;
    const bool isName = content.size() > 1 && content[0] == '.' && isWordStart(content[1]);
    throw Fault{token, format("'{}' is {}", excerpt(content), isName ? "no word" : "not a number"),
                isName ? "words begin with a letter or '_': put the name of a file in \"quotes\""
                       : numberAdvice(content)};
}

Token Lexer::run(TokenKind kind, std::size_t begin, std::size_t end) const
{
    const auto offset = static_cast<std::uint32_t>(begin);
    if (end - begin > limits::tokenBytes)
        throw Fault{Token{kind, file_, offset, 1},
                    format("this text of {} bytes is too long", end - begin),
                    format("a word, number or string has at most {} bytes", limits::tokenBytes)};
    return {kind, file_, offset, static_cast<std::uint32_t>(end - begin)};
}

void Lexer::refuseCharacter(std::size_t at) const
{
    const auto length = characterLength(text_, at);
    const auto character = text_.substr(at, length);
    const bool isAscii = length == 1;
    throw Fault{run(TokenKind::word, at, at + length),
                format("unexpected character '{}'", printable(character)),
                isAscii ? characterAdvice(character[0])
                        : "outside \"strings\" and comments only ASCII is read"};
}

} // namespace fpm
