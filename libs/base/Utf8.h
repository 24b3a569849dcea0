#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fpm {

/// Bytes of the UTF-8 character at `offset`; 0 where the bytes are not one (RFC 3629).
std::size_t characterLength(std::string_view text, std::size_t offset);

/// Number of characters; a byte that belongs to none counts as one.
std::size_t countCharacters(std::string_view text);

/// `text` fit for a terminal: control characters and bytes that are not UTF-8 become '?', tabs
/// stay.
std::string printable(std::string_view text);

/// The same line by line: line ends stay too.
std::string printableLines(std::string_view text);

/// printable(text), cut after 60 characters.
std::string excerpt(std::string_view text);

} // namespace fpm
