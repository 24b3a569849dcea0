#pragma once

#include "io/OutputFolder.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fpm {

/// An HDF5 file built in memory (core driver, no backing store) and put on disk in one piece:
/// complete or absent, with a checksum over all of it behind HDF5's own end.
/// Groups of a path are created on the way. Equal content gives equal bytes.
class Hdf5Image
{
public:
    Hdf5Image();
    ~Hdf5Image();
    Hdf5Image(Hdf5Image&&) noexcept;

    /// Rows of `columns` numbers (1 = plain vector). Path as "/VTKHDF/PointData/U".
    void write(const std::string& path, std::span<const double> values, std::size_t columns = 1);
    void write(const std::string& path, std::span<const float> values, std::size_t columns = 1);
    void
    write(const std::string& path, std::span<const std::int32_t> values, std::size_t columns = 1);
    void
    write(const std::string& path, std::span<const std::int64_t> values, std::size_t columns = 1);
    void
    write(const std::string& path, std::span<const std::uint8_t> values, std::size_t columns = 1);
    /// Fixed-length ASCII attribute (VTK accepts no other kind); creates the group.
    void attribute(const std::string& group, const std::string& name, const std::string& value);
    void attribute(const std::string& group,
                   const std::string& name,
                   std::span<const std::int64_t> values);
    void attribute(const std::string& group, const std::string& name, double value);
    /// External link: `path` here shows `target` of the file at relative path `file`.
    void link(const std::string& path, const std::string& file, const std::string& target);

    /// `label`: up to 255 bytes that can be read without opening the file.
    void
    save(const OutputFolder& output, const std::string& file, const std::string& label = "") const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// The label of a regular file that ends as Hdf5Image::save left it, "" where it has none; nothing
/// for any other. The rest of the file is not read.
std::optional<std::string> hdf5Label(const std::filesystem::path& file);

/// Reads files of Hdf5Image without trust: the checksum over the whole file is compared before HDF5
/// sees it, and HDF5 sees it in a child process only, which a file forged together with its
/// checksum may crash. Nothing is taken but what lies behind hard links: plain arrays of fixed-size
/// numbers, no larger than the file, and short attributes. Throws Error(mesh) naming the file,
/// Error(fileIo) where the system does not let it be read.
class Hdf5Reader
{
public:
    explicit Hdf5Reader(const std::filesystem::path& file);
    ~Hdf5Reader();
    Hdf5Reader(Hdf5Reader&&) noexcept;

    const std::string& label() const; ///< as it was given to Hdf5Image::save
    bool has(const std::string& path) const;
    bool hasAttribute(const std::string& group, const std::string& name) const;
    std::vector<std::string> children(const std::string& group) const; ///< sorted
    std::size_t columns(const std::string& path) const;                ///< 1 for a plain vector
    std::vector<double> doubles(const std::string& path) const;        ///< float32 is widened
    std::vector<std::int64_t> integers(const std::string& path) const;
    std::vector<std::byte> bytes(const std::string& path) const; ///< of an array of them
    std::string text(const std::string& group, const std::string& attribute) const;
    std::vector<std::int64_t> integers(const std::string& group,
                                       const std::string& attribute) const;
    double number(const std::string& group, const std::string& attribute) const;
    const std::filesystem::path& file() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

} // namespace fpm
