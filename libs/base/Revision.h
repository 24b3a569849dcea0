#pragma once

#include <cstddef>
#include <string_view>

namespace fpm {

constexpr std::string_view revisionHead = "fpm revision: ";
constexpr std::size_t revisionBytes = 64; ///< as long for every revision: nothing else moves

/// Head and revision, ended by zeros; made by etc/cmake/revision.cmake in every build.
extern const char revisionRecord[revisionBytes];

} // namespace fpm
