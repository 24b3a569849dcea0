#include "io/Hdf5Catalogue.h"

#include "base/Bytes.h"
#include "base/ChildProcess.h"
#include "base/Format.h"
#include "io/Hdf5Handle.h"
#include "io/Hdf5Seal.h"

namespace fpm::hdf5 {
namespace {

// A listing of a large mesh takes milliseconds and a few MiB: HDF5 reads no array for it.
constexpr std::uint64_t childMemory = std::uint64_t(1) << 30; // bytes
constexpr std::uint64_t childSeconds = 3;                     // of processor time

/// Takes in the records of a child, which may have been led astray: nothing is believed.
class CatalogueReader
{
public:
    CatalogueReader(const InputFile& file, const std::string& records)
        : file_(file),
          bytes_(records, format("'{}'", file.name().string()))
    {
    }

    Catalogue read()
    {
        for (;;) {
            const auto record = Record(bytes_.number());
            if (record == Record::end) return std::move(catalogue_);
            const std::string path = bytes_.text();
            if (record == Record::group)
                catalogue_.groups.insert(path);
            else if (record == Record::array)
                catalogue_.arrays[path] = readArray(path);
            else
                readAttribute(record, path);
        }
    }

private:
    ArrayPlace readArray(const std::string& path)
    {
        ArrayPlace place;
        place.kind = NumberKind(bytes_.number());
        place.bytesEach = std::uint64_t(bytes_.number());
        place.rows = std::uint64_t(bytes_.number());
        place.columns = std::uint64_t(bytes_.number());
        place.offset = std::uint64_t(bytes_.number());
        requireNumbers(place, path);
        requireRoom(place, path);
        return place;
    }

    void requireNumbers(const ArrayPlace& place, const std::string& path) const
    {
        const auto size = place.bytesEach;
        const bool isReal = place.kind == NumberKind::real && (size == 4 || size == 8);
        const bool isSigned = place.kind == NumberKind::signedInteger
                              && (size == 1 || size == 2 || size == 4 || size == 8);
        const bool isUnsigned =
            place.kind == NumberKind::unsignedInteger && (size == 1 || size == 2 || size == 4);
        if (!isReal && !isSigned && !isUnsigned)
            refuse(file_.name(), path + " holds neither integers nor IEEE numbers");
    }

    /// Arrays lie in the file and, in all, are no larger than it, though two may share their bytes.
    void requireRoom(const ArrayPlace& place, const std::string& path)
    {
        const std::uint64_t limit = (file_.size() - taken_) / place.bytesEach;
        const bool fits = place.rows == 0 || place.columns <= limit / place.rows;
        if (!fits || place.rows > limit)
            refuse(file_.name(), format("{} claims {} x {} values, more than the file can hold",
                                        path, place.rows, place.columns));
        const std::uint64_t size = place.rows * place.columns * place.bytesEach;
        if (size > 0 && (place.offset > file_.size() || size > file_.size() - place.offset))
            refuse(file_.name(), path + " lies outside of the file");
        taken_ += size;
    }

    void readAttribute(Record record, const std::string& path)
    {
        const std::string name = bytes_.text();
        AttributeValue& value = catalogue_.attributes[{path, name}];
        if (record == Record::text)
            value = bytes_.text();
        else if (record == Record::integers)
            value = bytes_.vector<std::int64_t>();
        else
            value = bytes_.vector<double>();
    }

    const InputFile& file_;
    ByteReader bytes_;
    Catalogue catalogue_;
    std::uint64_t taken_ = 0; ///< bytes of the arrays so far
};

} // namespace

Catalogue catalogueOf(const InputFile& file)
{
    initialise(); // once, and not in each child
    const ChildTask task{format("cannot read '{}'", file.name().string()), ExitCode::mesh,
                         "write it again with the utility that made it", childMemory, childSeconds};
    return CatalogueReader(file, inChild(task, [&] { return listContent(file); })).read();
}

} // namespace fpm::hdf5
