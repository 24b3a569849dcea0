#include "base/Format.h"
#include "io/Hdf5File.h"
#include "io/Hdf5Handle.h"
#include "io/Hdf5Seal.h"

#include <algorithm>
#include <array>

namespace fpm {

using namespace hdf5;

struct Hdf5Reader::Content {
    std::filesystem::path name;
    std::uint64_t size = 0; ///< of the file in bytes: no array can be longer
    File file;
};

namespace {

constexpr std::size_t maxTextLength = 65536;

/// Whether the path leads from the root to an object over hard links alone: links to other files or
/// to names that lie about where they lead are as good as absent.
bool isHard(hid_t file, const std::string& path)
{
    if (path == "/") return true;
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        H5L_info_t info;
        const std::string part = path.substr(0, end);
        const bool found = H5Lget_info(file, part.c_str(), &info, H5P_DEFAULT) >= 0;
        if (!found) H5Eclear2(H5E_DEFAULT);
        if (!found || info.type != H5L_TYPE_HARD) return false;
        if (end == std::string::npos) return true;
    }
}

template <class Content>
void requireHard(const Content& content, const std::string& path)
{
    if (!isHard(content.file, path)) refuse(content.name, path + " is missing");
}

template <class Content, class Result>
Result readable(const Content& content, Result result, const std::string& path)
{
    return checked(result, ExitCode::mesh,
                   "cannot read " + path + " of '" + content.name.string() + "'");
}

bool isIntegerType(hid_t type)
{
    const std::array<hid_t, 8> allowed{H5T_STD_I8LE,  H5T_STD_U8LE,  H5T_STD_I16LE, H5T_STD_U16LE,
                                       H5T_STD_I32LE, H5T_STD_U32LE, H5T_STD_I64LE, H5T_STD_U64LE};
    return std::ranges::any_of(allowed, [&](hid_t one) { return H5Tequal(type, one) > 0; });
}

bool isFloatType(hid_t type)
{
    return H5Tequal(type, H5T_IEEE_F32LE) > 0 || H5Tequal(type, H5T_IEEE_F64LE) > 0;
}

/// An opened array with its shape, checked to be plain and no larger than the file.
struct Array {
    Dataset dataset;
    std::array<hsize_t, 2> shape{0, 1};
    bool isFloat = false;
    std::size_t length() const { return std::size_t(shape[0] * shape[1]); }
};

template <class Content>
void requirePlainStorage(const Content& content, const Dataset& dataset, const std::string& path)
{
    const Properties properties(readable(content, H5Dget_create_plist(dataset), path));
    const H5D_layout_t layout = H5Pget_layout(properties);
    if ((layout != H5D_CONTIGUOUS && layout != H5D_COMPACT)
        || H5Pget_external_count(properties) != 0)
        refuse(content.name, path + " is stored chunked, filtered or outside of the file");
}

template <class Content>
Array openArray(const Content& content, const std::string& path)
{
    requireHard(content, path);
    Array array;
    array.dataset =
        Dataset(readable(content, H5Dopen2(content.file, path.c_str(), H5P_DEFAULT), path));
    const Type type(readable(content, H5Dget_type(array.dataset), path));
    array.isFloat = isFloatType(type);
    if (!array.isFloat && !isIntegerType(type))
        refuse(content.name, path + " holds neither integers nor IEEE numbers");
    requirePlainStorage(content, array.dataset, path);
    const Space space(readable(content, H5Dget_space(array.dataset), path));
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank != 1 && rank != 2)
        refuse(content.name, format("{} has {} dimensions; 1 or 2 expected", path, rank));
    readable(content, H5Sget_simple_extent_dims(space, array.shape.data(), nullptr), path);
    const std::uint64_t limit = content.size / H5Tget_size(type);
    if (array.shape[0] > limit || (array.shape[0] > 0 && array.shape[1] > limit / array.shape[0]))
        refuse(content.name, format("{} claims {} x {} values, more than the file can hold", path,
                                    std::uint64_t(array.shape[0]), std::uint64_t(array.shape[1])));
    return array;
}

template <class T, class Content>
std::vector<T>
readNumbers(const Content& content, const Array& array, const std::string& path, hid_t inMemory)
{
    std::vector<T> values(array.length());
    if (values.empty()) return values;
    readable(content,
             H5Dread(array.dataset, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), path);
    return values;
}

/// An opened attribute, its type and its number of values.
struct OpenAttribute {
    Attribute attribute;
    Type type;
    std::size_t length = 0;
};

template <class Content>
OpenAttribute
openAttribute(const Content& content, const std::string& group, const std::string& name)
{
    const std::string path = group + " attribute " + name;
    requireHard(content, group);
    OpenAttribute found;
    const hid_t number =
        H5Aopen_by_name(content.file, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    found.attribute = Attribute(readable(content, number, path));
    found.type = Type(readable(content, H5Aget_type(found.attribute), path));
    const Space space(readable(content, H5Aget_space(found.attribute), path));
    const hssize_t length = readable(content, H5Sget_simple_extent_npoints(space), path);
    found.length = std::size_t(length);
    if (found.length > maxTextLength) refuse(content.name, path + " is too long");
    return found;
}

} // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : content_(std::make_unique<Content>())
{
    initialise();
    content_->name = file;
    content_->size = verifySeal(file);
    const Properties access(readable(*content_, H5Pcreate(H5P_FILE_ACCESS), "/"));
    // Complete files never change, and file systems without locks must do.
    readable(*content_, H5Pset_file_locking(access, false, true), "/");
    content_->file = File(readable(*content_, H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), "/"));
}

Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;

const std::filesystem::path& Hdf5Reader::file() const
{
    return content_->name;
}

bool Hdf5Reader::has(const std::string& path) const
{
    return isHard(content_->file, path);
}

bool Hdf5Reader::hasAttribute(const std::string& group, const std::string& name) const
{
    return isHard(content_->file, group)
           && H5Aexists_by_name(content_->file, group.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::children(const std::string& group) const
{
    requireHard(*content_, group);
    const Group opened(
        readable(*content_, H5Gopen2(content_->file, group.c_str(), H5P_DEFAULT), group));
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    readable(*content_, H5Literate(opened, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names),
             group);
    std::ranges::sort(names);
    return names;
}

std::size_t Hdf5Reader::columns(const std::string& path) const
{
    return std::size_t(openArray(*content_, path).shape[1]);
}

std::vector<double> Hdf5Reader::doubles(const std::string& path) const
{
    return readNumbers<double>(*content_, openArray(*content_, path), path, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path) const
{
    const Array array = openArray(*content_, path);
    if (array.isFloat) refuse(content_->name, path + " holds no integers");
    return readNumbers<std::int64_t>(*content_, array, path, H5T_NATIVE_INT64);
}

std::vector<std::byte> Hdf5Reader::bytes(const std::string& path) const
{
    const Array array = openArray(*content_, path);
    const Type type(readable(*content_, H5Dget_type(array.dataset), path));
    if (H5Tget_size(type) != 1) refuse(content_->name, path + " holds no bytes");
    return readNumbers<std::byte>(*content_, array, path, H5T_NATIVE_UINT8);
}

std::string Hdf5Reader::text(const std::string& group, const std::string& attribute) const
{
    const auto found = openAttribute(*content_, group, attribute);
    const std::size_t size = H5Tget_size(found.type);
    if (H5Tget_class(found.type) != H5T_STRING || H5Tis_variable_str(found.type) != 0
        || found.length != 1 || size == 0 || size > maxTextLength)
        refuse(content_->name, group + " attribute " + attribute + " is not a short text");
    std::string value(size, '\0');
    readable(*content_, H5Aread(found.attribute, found.type, value.data()), group);
    return value.substr(0, value.find('\0'));
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& group,
                                               const std::string& attribute) const
{
    const auto found = openAttribute(*content_, group, attribute);
    if (!isIntegerType(found.type))
        refuse(content_->name, group + " attribute " + attribute + " holds no integers");
    std::vector<std::int64_t> values(found.length);
    if (!values.empty())
        readable(*content_, H5Aread(found.attribute, H5T_NATIVE_INT64, values.data()), group);
    return values;
}

double Hdf5Reader::number(const std::string& group, const std::string& attribute) const
{
    const auto found = openAttribute(*content_, group, attribute);
    if (found.length != 1 || (!isFloatType(found.type) && !isIntegerType(found.type)))
        refuse(content_->name, group + " attribute " + attribute + " is not a number");
    double value = 0;
    readable(*content_, H5Aread(found.attribute, H5T_NATIVE_DOUBLE, &value), group);
    return value;
}

} // namespace fpm
