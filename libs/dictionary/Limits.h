#pragma once

#include <cstddef>
#include <cstdint>

/// What a dictionary may ask of the machine that reads it. Generous for people, small for memory.
namespace fpm::limits {

inline constexpr std::uint64_t fileBytes = std::uint64_t(64) << 20; ///< all files of one dictionary
inline constexpr std::size_t tokenBytes = 64 << 10;
inline constexpr std::size_t keywordBytes = 64; ///< keywords name files and folders
inline constexpr int nesting = 64;              ///< of braces and brackets together
inline constexpr std::size_t includeDepth = 16;
inline constexpr std::size_t files = 256;
inline constexpr std::size_t entries = 1'000'000; ///< entries and dictionaries together
inline constexpr int macroDepth = 32;
inline constexpr std::uint64_t expandedBytes = 8 << 20; ///< or expansionFactor times the input
inline constexpr std::uint64_t expansionFactor = 100;

/// Magnitudes of numbers other than 0: squares of them are numbers too, and no length of a vector
/// comes out as 0 or as infinite.
inline constexpr double largestNumber = 1e150, smallestNumber = 1e-150;

} // namespace fpm::limits
