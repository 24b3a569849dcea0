#pragma once

#include "dictionary/Document.h"

namespace fpm {

/// Cuts one file into tokens, one ahead of its reader. Throws Fault.
class Lexer
{
public:
    Lexer(const Document& document, std::uint16_t file);

    const Token& peek() const { return next_; }
    Token take();

private:
    std::size_t blankEnd(std::size_t at) const;
    std::size_t commentEnd(std::size_t at) const;
    Token tokenAt(std::size_t at) const;
    Token string(std::size_t at) const;
    Token macro(std::size_t at) const;
    Token number(std::size_t at) const;
    Token run(TokenKind kind, std::size_t begin, std::size_t end) const;
    [[noreturn]] void refuseCharacter(std::size_t at) const;

    std::string_view text_;
    std::uint16_t file_;
    Token next_;
};

bool isWordStart(char character); ///< [A-Za-z_]
bool isWordPart(char character);  ///< [A-Za-z0-9_.:-]

} // namespace fpm
