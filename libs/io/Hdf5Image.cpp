#include "base/Format.h"
#include "io/Checksum.h"
#include "io/Hdf5File.h"
#include "io/Hdf5Handle.h"
#include "io/Hdf5Seal.h"

#include <algorithm>
#include <array>

namespace fpm {

using namespace hdf5;

struct Hdf5Image::Content {
    File file;
    Properties links, groups, datasets; ///< creation properties
};

namespace {

template <class Result>
Result written(Result result, const std::string& path)
{
    return checked(result, ExitCode::internal, "cannot write " + path + " into an HDF5 image");
}

struct NumberType {
    hid_t inFile, inMemory;
};
// The identifiers are macros that call the library: known only at run time.
NumberType typeOf(double)
{
    return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
}
NumberType typeOf(float)
{
    return {H5T_IEEE_F32LE, H5T_NATIVE_FLOAT};
}
NumberType typeOf(std::int32_t)
{
    return {H5T_STD_I32LE, H5T_NATIVE_INT32};
}
NumberType typeOf(std::int64_t)
{
    return {H5T_STD_I64LE, H5T_NATIVE_INT64};
}
NumberType typeOf(std::uint8_t)
{
    return {H5T_STD_U8LE, H5T_NATIVE_UINT8};
}

/// `Content` is private to Hdf5Image, hence a template parameter.
template <class Content, class T>
void writeNumbers(const Content& content,
                  const std::string& path,
                  std::span<const T> values,
                  std::size_t columns)
{
    if (columns == 0 || values.size() % columns != 0)
        throw Error(ExitCode::internal,
                    format("{}: {} values do not fill rows of {}", path, values.size(), columns));
    const std::array<hsize_t, 2> shape{values.size() / columns, columns};
    const Space space(written(H5Screate_simple(columns == 1 ? 1 : 2, shape.data(), nullptr), path));
    const auto [inFile, inMemory] = typeOf(T());
    const Dataset dataset(written(H5Dcreate2(content.file, path.c_str(), inFile, space,
                                             content.links, content.datasets, H5P_DEFAULT),
                                  path));
    if (values.empty()) return;
    written(H5Dwrite(dataset, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path);
}

/// Opens the group, after creating it and those above where they are missing.
template <class Content>
Object openGroup(const Content& content, const std::string& path)
{
    for (std::size_t end = path.find('/', 1); path.size() > 1; end = path.find('/', end + 1)) {
        const std::string part = path.substr(0, end);
        if (written(H5Lexists(content.file, part.c_str(), H5P_DEFAULT), path) == 0)
            Group(written(
                H5Gcreate2(content.file, part.c_str(), H5P_DEFAULT, content.groups, H5P_DEFAULT),
                path));
        if (end == std::string::npos) break;
    }
    return Object(written(H5Oopen(content.file, path.c_str(), H5P_DEFAULT), path));
}

void writeAttribute(const Object& object,
                    const std::string& name,
                    hid_t inFile,
                    hid_t inMemory,
                    const Space& space,
                    const void* value)
{
    const Attribute attribute(
        written(H5Acreate2(object, name.c_str(), inFile, space, H5P_DEFAULT, H5P_DEFAULT), name));
    written(H5Awrite(attribute, inMemory, value), name);
}

} // namespace

Hdf5Image::Hdf5Image() : content_(std::make_unique<Content>())
{
    initialise();
    constexpr std::size_t growth = std::size_t(1) << 22;
    const Properties access(written(H5Pcreate(H5P_FILE_ACCESS), "/"));
    written(H5Pset_fapl_core(access, growth, false), "/");
    // The oldest format that holds the content: HDF5 1.10 and every ParaView read it.
    written(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V110), "/");
    // Without times of creation equal runs give equal bytes.
    content_->groups = Properties(written(H5Pcreate(H5P_GROUP_CREATE), "/"));
    written(H5Pset_obj_track_times(content_->groups, false), "/");
    content_->datasets = Properties(written(H5Pcreate(H5P_DATASET_CREATE), "/"));
    written(H5Pset_obj_track_times(content_->datasets, false), "/");
    content_->links = Properties(written(H5Pcreate(H5P_LINK_CREATE), "/"));
    written(H5Pset_create_intermediate_group(content_->links, 1), "/");
    // HDF5 looks first whether there is a file of this name, and reads it all: there can be none.
    content_->file =
        File(written(H5Fcreate("/dev/null/image", H5F_ACC_TRUNC, H5P_DEFAULT, access), "/"));
}

Hdf5Image::~Hdf5Image() = default;
Hdf5Image::Hdf5Image(Hdf5Image&&) noexcept = default;

void Hdf5Image::write(const std::string& path, std::span<const double> values, std::size_t columns)
{
    writeNumbers(*content_, path, values, columns);
}

void Hdf5Image::write(const std::string& path, std::span<const float> values, std::size_t columns)
{
    writeNumbers(*content_, path, values, columns);
}

void Hdf5Image::write(const std::string& path,
                      std::span<const std::int32_t> values,
                      std::size_t columns)
{
    writeNumbers(*content_, path, values, columns);
}

void Hdf5Image::write(const std::string& path,
                      std::span<const std::int64_t> values,
                      std::size_t columns)
{
    writeNumbers(*content_, path, values, columns);
}

void Hdf5Image::write(const std::string& path,
                      std::span<const std::uint8_t> values,
                      std::size_t columns)
{
    writeNumbers(*content_, path, values, columns);
}

void Hdf5Image::attribute(const std::string& group,
                          const std::string& name,
                          const std::string& value)
{
    const Type type(written(H5Tcopy(H5T_C_S1), name));
    // HDF5 has no strings of length 0; null-padding makes one NUL read back as empty.
    const std::string stored = value.empty() ? std::string(1, '\0') : value;
    written(H5Tset_size(type, stored.size()), name);
    written(H5Tset_strpad(type, H5T_STR_NULLPAD), name);
    written(H5Tset_cset(type, H5T_CSET_ASCII), name);
    const Space space(written(H5Screate(H5S_SCALAR), name));
    writeAttribute(openGroup(*content_, group), name, type, type, space, stored.data());
}

void Hdf5Image::attribute(const std::string& group,
                          const std::string& name,
                          std::span<const std::int64_t> values)
{
    const hsize_t length = values.size();
    const Space space(written(H5Screate_simple(1, &length, nullptr), name));
    const auto [inFile, inMemory] = typeOf(std::int64_t());
    writeAttribute(openGroup(*content_, group), name, inFile, inMemory, space, values.data());
}

void Hdf5Image::attribute(const std::string& group, const std::string& name, double value)
{
    const Space space(written(H5Screate(H5S_SCALAR), name));
    const auto [inFile, inMemory] = typeOf(double());
    writeAttribute(openGroup(*content_, group), name, inFile, inMemory, space, &value);
}

void Hdf5Image::link(const std::string& path, const std::string& file, const std::string& target)
{
    written(H5Lcreate_external(file.c_str(), target.c_str(), content_->file, path.c_str(),
                               content_->links, H5P_DEFAULT),
            path);
}

void Hdf5Image::save(const OutputFolder& output,
                     const std::string& file,
                     const std::string& label) const
{
    written(H5Fflush(content_->file, H5F_SCOPE_LOCAL), file);
    const auto size = written(H5Fget_file_image(content_->file, nullptr, 0), file);
    std::vector<std::byte> bytes(std::size_t(size) + label.size() + sizeof(Seal));
    const auto image = std::span(bytes).first(std::size_t(size));
    written(H5Fget_file_image(content_->file, image.data(), image.size()), file);
    std::ranges::copy(std::as_bytes(std::span(label)), bytes.begin() + size);
    Checksum checksum;
    checksum.add(std::span(bytes).first(image.size() + label.size()));
    std::ranges::copy(makeSeal(checksum.value(), label.size()), bytes.end() - sizeof(Seal));
    output.write(file, bytes);
}

} // namespace fpm
