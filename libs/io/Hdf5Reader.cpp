#include "io/Hdf5Catalogue.h"
#include "io/Hdf5File.h"
#include "io/Hdf5Seal.h"

#include <algorithm>
#include <bit>
#include <type_traits>

namespace fpm {

using namespace hdf5;

struct Hdf5Reader::Content {
    InputFile file;
    std::string label;
    Catalogue catalogue;

    [[noreturn]] void refuse(const std::string& reason) const { hdf5::refuse(file.name(), reason); }

    const ArrayPlace& array(const std::string& path) const
    {
        const auto found = catalogue.arrays.find(path);
        if (found == catalogue.arrays.end())
            refuse(path + (catalogue.groups.contains(path) ? " is no array" : " is missing"));
        return found->second;
    }

    const AttributeValue& attribute(const std::string& group, const std::string& name) const
    {
        const auto found = catalogue.attributes.find({group, name});
        if (found == catalogue.attributes.end())
            refuse(group + " attribute " + name + " is missing");
        return found->second;
    }
};

namespace {

static_assert(std::endian::native == std::endian::little, "as the numbers in the files");

/// Reads numbers stored as `Stored` into values of T.
template <class Stored, class T>
bool readAs(const InputFile& file, std::uint64_t offset, std::vector<T>& values)
{
    if constexpr (std::is_same_v<Stored, T>) {
        return file.read(offset, std::as_writable_bytes(std::span(values)));
    } else {
        constexpr std::size_t blockLength = 1 << 16;
        std::vector<Stored> block(std::min(blockLength, values.size()));
        for (std::size_t first = 0; first < values.size(); first += blockLength) {
            const auto part = std::span(block).first(std::min(blockLength, values.size() - first));
            if (!file.read(offset + first * sizeof(Stored), std::as_writable_bytes(part)))
                return false;
            std::ranges::transform(part, values.begin() + std::ptrdiff_t(first),
                                   [](Stored value) { return T(value); });
        }
        return true;
    }
}

template <class T>
bool readIntegers(const InputFile& file, const ArrayPlace& place, std::vector<T>& values)
{
    const bool isSigned = place.kind == NumberKind::signedInteger;
    const std::uint64_t at = place.offset;
    // Unsigned ones of 8 bytes are refused.
    switch (place.bytesEach) {
    case 1:
        return isSigned ? readAs<std::int8_t>(file, at, values)
                        : readAs<std::uint8_t>(file, at, values);
    case 2:
        return isSigned ? readAs<std::int16_t>(file, at, values)
                        : readAs<std::uint16_t>(file, at, values);
    case 4:
        return isSigned ? readAs<std::int32_t>(file, at, values)
                        : readAs<std::uint32_t>(file, at, values);
    default:
        return readAs<std::int64_t>(file, at, values);
    }
}

template <class T, class Content>
std::vector<T> readNumbers(const Content& content, const std::string& path)
{
    const ArrayPlace& place = content.array(path);
    std::vector<T> values(std::size_t(place.rows * place.columns));
    bool isRead = true;
    if constexpr (std::is_floating_point_v<T>)
        isRead = place.kind != NumberKind::real ? readIntegers(content.file, place, values)
                 : place.bytesEach == 4         ? readAs<float>(content.file, place.offset, values)
                                        : readAs<double>(content.file, place.offset, values);
    else if (place.kind == NumberKind::real)
        content.refuse(path + " holds no integers");
    else
        isRead = readIntegers(content.file, place, values);
    if (!isRead) content.refuse(path + ": read error");
    return values;
}

} // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
{
    InputFile input(file);
    std::string label = verifySeal(input);
    Catalogue catalogue = catalogueOf(input);
    content_ = std::make_unique<Content>(
        Content{std::move(input), std::move(label), std::move(catalogue)});
}

Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;

const std::filesystem::path& Hdf5Reader::file() const
{
    return content_->file.name();
}

const std::string& Hdf5Reader::label() const
{
    return content_->label;
}

bool Hdf5Reader::has(const std::string& path) const
{
    const Catalogue& catalogue = content_->catalogue;
    return catalogue.groups.contains(path) || catalogue.arrays.contains(path);
}

bool Hdf5Reader::hasAttribute(const std::string& group, const std::string& name) const
{
    return content_->catalogue.attributes.contains({group, name});
}

std::vector<std::string> Hdf5Reader::children(const std::string& group) const
{
    const Catalogue& catalogue = content_->catalogue;
    if (!catalogue.groups.contains(group))
        content_->refuse(group
                         + (catalogue.arrays.contains(group) ? " is no group" : " is missing"));
    const std::string above = group == "/" ? group : group + "/";
    std::vector<std::string> names;
    const auto keep = [&](const std::string& path) {
        if (path.size() > above.size() && path.starts_with(above)
            && path.find('/', above.size()) == path.npos)
            names.push_back(path.substr(above.size()));
    };
    for (const auto& path : catalogue.groups) keep(path);
    for (const auto& [path, place] : catalogue.arrays) keep(path);
    std::ranges::sort(names);
    return names;
}

std::size_t Hdf5Reader::columns(const std::string& path) const
{
    return std::size_t(content_->array(path).columns);
}

std::vector<double> Hdf5Reader::doubles(const std::string& path) const
{
    return readNumbers<double>(*content_, path);
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path) const
{
    return readNumbers<std::int64_t>(*content_, path);
}

std::vector<std::byte> Hdf5Reader::bytes(const std::string& path) const
{
    const ArrayPlace& place = content_->array(path);
    if (place.bytesEach != 1) content_->refuse(path + " holds no bytes");
    std::vector<std::byte> values(std::size_t(place.rows * place.columns));
    if (!content_->file.read(place.offset, values)) content_->refuse(path + ": read error");
    return values;
}

std::string Hdf5Reader::text(const std::string& group, const std::string& attribute) const
{
    const auto* value = std::get_if<std::string>(&content_->attribute(group, attribute));
    if (!value) content_->refuse(group + " attribute " + attribute + " is not a short text");
    return *value;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& group,
                                               const std::string& attribute) const
{
    const auto* values =
        std::get_if<std::vector<std::int64_t>>(&content_->attribute(group, attribute));
    if (!values) content_->refuse(group + " attribute " + attribute + " holds no integers");
    return *values;
}

double Hdf5Reader::number(const std::string& group, const std::string& attribute) const
{
    const AttributeValue& value = content_->attribute(group, attribute);
    const auto* reals = std::get_if<std::vector<double>>(&value);
    const auto* integers = std::get_if<std::vector<std::int64_t>>(&value);
    if (reals && reals->size() == 1) return reals->front();
    if (integers && integers->size() == 1) return double(integers->front());
    content_->refuse(group + " attribute " + attribute + " is not a number");
}

} // namespace fpm
