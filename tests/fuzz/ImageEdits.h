#pragma once

#include "fuzz/InputBytes.h"
#include "io/Hdf5File.h"

#include <string>
#include <variant>
#include <vector>

namespace fpm::fuzz {

/// An array or attribute of an HDF5 file of ours.
struct Item {
    std::string path;      ///< of the array, or of the group with the attribute
    std::string attribute; ///< empty: an array
    std::size_t columns = 1;
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::string> value;
    bool bytes = false; ///< whole numbers of an array are written as bytes
};

/// What a file holds, which can be changed and written again: so the edited file has a good
/// checksum and is sound HDF5, and what it says is wrong.
class ImageEdits
{
public:
    /// Every array below `group`, and the attributes of these names.
    ImageEdits(const std::filesystem::path& file, const std::vector<std::string>& attributes);
    /// Changes values, numbers of rows and columns, types and names, until the input ends.
    void apply(InputBytes& input);
    void write(const std::filesystem::path& folder,
               const std::string& file,
               const std::string& label) const;

private:
    void collect(const Hdf5Reader& reader,
                 const std::string& path,
                 const std::vector<std::string>& attributes);
    void edit(std::size_t number, InputBytes& input);

    std::vector<Item> items_;
};

} // namespace fpm::fuzz
