#pragma once

#include "io/InputFile.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What stands where in an HDF5 file. HDF5 itself runs only in a child process, which lists the
/// file, since the library is not built for hostile bytes; numbers of arrays are then read from
/// their places without it.
namespace fpm::hdf5 {

enum class NumberKind : std::int64_t { signedInteger, unsignedInteger, real };

/// Rows of numbers, little-endian, that lie side by side in the file.
struct ArrayPlace {
    NumberKind kind = NumberKind::real;
    std::uint64_t bytesEach = 8; ///< 1, 2, 4 or 8; real: 4 or 8, unsigned: not 8
    std::uint64_t rows = 0, columns = 1;
    std::uint64_t offset = 0; ///< bytes from the begin of the file
};

using AttributeValue = std::variant<std::string, std::vector<std::int64_t>, std::vector<double>>;

struct Catalogue {
    std::set<std::string> groups; ///< paths; "/" is the root
    std::map<std::string, ArrayPlace> arrays;
    std::map<std::pair<std::string, std::string>, AttributeValue> attributes; ///< path, name
};

/// Of a file whose seal is verified. Links other than hard ones are left out, and so is what lies
/// behind them. Throws Error(mesh) for what Hdf5Image does not write, arrays that do not lie in the
/// file, and a child that crashes or takes too much memory or time.
Catalogue catalogueOf(const InputFile& file);

/// The child's part: the file as records of bytes (base/Bytes.h), each with its kind before it.
std::string listContent(const InputFile& file);
enum class Record : std::int64_t { end, group, array, text, integers, reals };

} // namespace fpm::hdf5
