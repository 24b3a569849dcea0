#include "base/Bytes.h"
#include "base/Format.h"
#include "io/Hdf5Catalogue.h"
#include "io/Hdf5Handle.h"
#include "io/Hdf5Seal.h"

#include <algorithm>
#include <array>

namespace fpm::hdf5 {
namespace {

constexpr std::size_t maxTextLength = 65536, maxNameLength = 255;
constexpr int maxDepth = 16;
constexpr std::uint64_t leastObject = 64; ///< bytes that an object takes at least

bool isIntegerType(hid_t type)
{
    const std::array<hid_t, 7> allowed{H5T_STD_I8LE,  H5T_STD_U8LE,  H5T_STD_I16LE, H5T_STD_U16LE,
                                       H5T_STD_I32LE, H5T_STD_U32LE, H5T_STD_I64LE};
    return std::ranges::any_of(allowed, [&](hid_t one) { return H5Tequal(type, one) > 0; });
}

bool isFloatType(hid_t type)
{
    return H5Tequal(type, H5T_IEEE_F32LE) > 0 || H5Tequal(type, H5T_IEEE_F64LE) > 0;
}

/// Names end in messages and in paths.
bool isGoodName(const std::string& name)
{
    return !name.empty() && name != "." && name.size() <= maxNameLength
           && std::ranges::all_of(name, [](char c) { return c >= ' ' && c <= '~' && c != '/'; });
}

class Lister
{
public:
    explicit Lister(const InputFile& file) : file_(file), left_(file.size() / leastObject)
    {
        const Properties access(readable(H5Pcreate(H5P_FILE_ACCESS), "/"));
        // Complete files never change, and file systems without locks must do.
        readable(H5Pset_file_locking(access, false, true), "/");
        opened_ =
            File(readable(H5Fopen(file.descriptorPath().c_str(), H5F_ACC_RDONLY, access), "/"));
    }

    std::string list()
    {
        listGroup(Object(readable(H5Oopen(opened_, "/", H5P_DEFAULT), "/")), "", maxDepth);
        put(Record::end);
        return bytes_.take();
    }

private:
    template <class Result>
    Result readable(Result result, const std::string& path) const
    {
        return checked(result, ExitCode::mesh,
                       "cannot read " + path + " of '" + file_.name().string() + "'");
    }

    [[noreturn]] void fail(const std::string& reason) const { refuse(file_.name(), reason); }

    void put(Record record) { bytes_.put(std::int64_t(record)); }

    void put(Record record, const std::string& path)
    {
        put(record);
        bytes_.put(path);
    }

    /// Hard links alone; other files, and names that lie about where they lead, are not visited.
    std::vector<std::string> hardLinks(const Object& group, const std::string& path) const
    {
        std::vector<std::string> names;
        const auto keep = [](hid_t, const char* name, const H5L_info_t* info, void* out) -> herr_t {
            if (info->type == H5L_TYPE_HARD)
                static_cast<std::vector<std::string>*>(out)->emplace_back(name);
            return 0;
        };
        readable(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names), path);
        return names;
    }

    void requireNoFilters(hid_t properties, const std::string& path) const
    {
        if (H5Pget_nfilters(properties) != 0) fail(path + " has filters");
    }

    void listGroup(const Object& group, const std::string& path, int depth)
    {
        const std::string here = path.empty() ? "/" : path;
        if (depth == 0) fail("groups stand deeper in each other than we write them");
        const Properties properties(readable(H5Gget_create_plist(group), here));
        requireNoFilters(properties, here);
        put(Record::group, here);
        listAttributes(group, here);
        for (const std::string& name : hardLinks(group, here)) {
            if (!isGoodName(name)) fail("an object of " + here + " has a name that cannot be used");
            if (left_-- == 0) fail("there are more objects than the file can hold");
            listObject(Object(readable(H5Oopen(group, name.c_str(), H5P_DEFAULT), here)),
                       path + "/" + name, depth);
        }
    }

    void listObject(const Object& object, const std::string& path, int depth)
    {
        switch (H5Iget_type(object)) {
        case H5I_GROUP:
            return listGroup(object, path, depth - 1);
        case H5I_DATASET:
            listArray(object, path);
            return listAttributes(object, path);
        default:
            fail(path + " is neither a group nor an array");
        }
    }

    void requirePlainStorage(const Object& dataset, const std::string& path) const
    {
        const Properties properties(readable(H5Dget_create_plist(dataset), path));
        if (H5Pget_layout(properties) != H5D_CONTIGUOUS || H5Pget_external_count(properties) != 0)
            fail(path + " is stored compact, chunked, virtual or outside of the file");
        requireNoFilters(properties, path);
    }

    void listArray(const Object& dataset, const std::string& path)
    {
        const Type type(readable(H5Dget_type(dataset), path));
        const bool isFloat = isFloatType(type);
        if (!isFloat && !isIntegerType(type))
            fail(path + " holds neither integers nor IEEE numbers");
        requirePlainStorage(dataset, path);
        const Space space(readable(H5Dget_space(dataset), path));
        const int rank = H5Sget_simple_extent_ndims(space);
        if (rank != 1 && rank != 2)
            fail(format("{} has {} dimensions; 1 or 2 expected", path, rank));
        std::array<hsize_t, 2> shape{0, 1};
        readable(H5Sget_simple_extent_dims(space, shape.data(), nullptr), path);
        const bool isSigned = isFloat || H5Tget_sign(type) == H5T_SGN_2;
        put(Record::array, path);
        bytes_.put(std::int64_t(isFloat    ? NumberKind::real
                                : isSigned ? NumberKind::signedInteger
                                           : NumberKind::unsignedInteger));
        bytes_.put(std::int64_t(H5Tget_size(type)));
        for (const hsize_t extent : shape) bytes_.put(std::int64_t(extent));
        bytes_.put(std::int64_t(H5Dget_offset(dataset))); // beyond any file where nothing is stored
    }

    void listAttributes(const Object& object, const std::string& path)
    {
        std::vector<std::string> names;
        const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
            static_cast<std::vector<std::string>*>(out)->emplace_back(name);
            return 0;
        };
        readable(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names), path);
        for (const std::string& name : names) {
            if (!isGoodName(name))
                fail("an attribute of " + path + " has a name that cannot be used");
            const Attribute attribute(readable(H5Aopen(object, name.c_str(), H5P_DEFAULT), path));
            listAttribute(attribute, path, name);
        }
    }

    void listAttribute(const Attribute& attribute, const std::string& path, const std::string& name)
    {
        const std::string both = path + " attribute " + name;
        const Type type(readable(H5Aget_type(attribute), both));
        const Space space(readable(H5Aget_space(attribute), both));
        const auto length = std::size_t(readable(H5Sget_simple_extent_npoints(space), both));
        if (length > maxTextLength) fail(both + " is too long");
        if (isIntegerType(type)) {
            putNumbers<std::int64_t>(Record::integers, attribute, path, name, length,
                                     H5T_NATIVE_INT64);
        } else if (isFloatType(type)) {
            putNumbers<double>(Record::reals, attribute, path, name, length, H5T_NATIVE_DOUBLE);
        } else {
            const std::size_t size = H5Tget_size(type);
            if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || length != 1
                || size == 0 || size > maxTextLength)
                fail(both + " is neither numbers nor a short text");
            std::string value(size, '\0');
            readable(H5Aread(attribute, type, value.data()), both);
            put(Record::text, path);
            bytes_.put(name);
            bytes_.put(value.substr(0, value.find('\0')));
        }
    }

    template <class T>
    void putNumbers(Record record,
                    const Attribute& attribute,
                    const std::string& path,
                    const std::string& name,
                    std::size_t length,
                    hid_t inMemory)
    {
        std::vector<T> values(length);
        if (length > 0) readable(H5Aread(attribute, inMemory, values.data()), path);
        put(record, path);
        bytes_.put(name);
        bytes_.put(values);
    }

    const InputFile& file_;
    std::uint64_t left_; ///< objects that may follow
    File opened_;
    ByteWriter bytes_;
};

} // namespace

std::string listContent(const InputFile& file)
{
    initialise();
    return Lister(file).list();
}

} // namespace fpm::hdf5
