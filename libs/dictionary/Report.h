#pragma once

#include "dictionary/Document.h"

#include <string>

namespace fpm {

/// Both start at 1; columns count characters, not bytes.
struct LineAndColumn {
    std::size_t line, column;
};
LineAndColumn lineAndColumn(std::string_view text, std::size_t offset);

/// What a wrong dictionary is answered with:
///
///     unknown keyword 'fricton'
///       --> system/contactDict:14:9, in pairs.rodPlate
///        |
///     14 |         fricton     0.3;
///        |         ^^^^^^^
///        = did you mean 'friction'?
///
/// `path` (may be empty) is the dictionary's, `advice` may be empty.
std::string report(const Document& document,
                   const Token& at,
                   const std::string& path,
                   const std::string& message,
                   const std::string& advice);

/// The same where there is no place in the text, such as a key missing at the top of `file`.
std::string report(const std::string& file,
                   const std::string& path,
                   const std::string& message,
                   const std::string& advice);

} // namespace fpm
