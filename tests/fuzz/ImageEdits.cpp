#include "fuzz/ImageEdits.h"

#include "base/Error.h"
#include "fuzz/tried.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fpm::fuzz {
namespace {

constexpr std::size_t mostValues = 4096;
constexpr std::int64_t one = 1;

/// Whole numbers at which readers err: signs, ends of types, sizes that overflow when multiplied.
std::int64_t wholeNumber(InputBytes& input)
{
    constexpr std::array special{-one,
                                 std::int64_t(0),
                                 one,
                                 std::int64_t(2),
                                 std::int64_t(7),
                                 std::int64_t(8),
                                 one << 31,
                                 -one << 31,
                                 (one << 31) - 1,
                                 one << 32,
                                 one << 61,
                                 std::numeric_limits<std::int64_t>::max(),
                                 std::numeric_limits<std::int64_t>::min()};
    const std::size_t which = input.byte();
    if (which < 2 * special.size()) return special[which % special.size()];
    return std::int64_t(which) - 64;
}

double realNumber(InputBytes& input)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array special{
        0.0,  -0.0,  1.0,      -1.0,      1e15,
        2e15, 1e300, -1e300,   1e-310,    0.1,
        1e38, 1e39,  infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    const std::size_t which = input.byte();
    if (which < 2 * special.size()) return special[which % special.size()];
    return double(which) / 16 - 8;
}

void setNumber(std::vector<double>& values, std::size_t place, InputBytes& input)
{
    values[place] = realNumber(input);
}

void setNumber(std::vector<std::int64_t>& values, std::size_t place, InputBytes& input)
{
    values[place] = wholeNumber(input);
}

void editText(std::string& text, InputBytes& input)
{
    const std::size_t place = input.below(text.size() + 1);
    if (input.byte() % 2 == 0 && place < text.size())
        text[place] = char(input.byte());
    else
        text.insert(place, input.text(1 + input.byte() % 8));
}

template <class T>
void editNumbers(Item& item, std::vector<T>& values, InputBytes& input)
{
    switch (input.byte() % 4) {
    case 0:
    case 1:
        if (!values.empty()) setNumber(values, input.below(values.size()), input);
        return;
    case 2: // more or fewer rows
        values.resize(input.below(2 * values.size() + 2) / item.columns * item.columns);
        return;
    default: // as many values in other rows
        item.columns = 1 + input.byte() % 9;
        values.resize(std::min(values.size(), mostValues) / item.columns * item.columns);
    }
}

void swapType(Item& item)
{
    if (const auto* numbers = std::get_if<std::vector<std::int64_t>>(&item.value))
        item.value = std::vector<double>(numbers->begin(), numbers->end());
    else if (const auto* reals = std::get_if<std::vector<double>>(&item.value))
        item.value = std::vector<std::int64_t>(reals->size(), 1);
}

void writeItem(Hdf5Image& image, const Item& item)
{
    const auto* text = std::get_if<std::string>(&item.value);
    const auto* reals = std::get_if<std::vector<double>>(&item.value);
    const auto* numbers = std::get_if<std::vector<std::int64_t>>(&item.value);
    if (item.attribute.empty() && reals)
        image.write(item.path, std::span<const double>(*reals), item.columns);
    else if (item.attribute.empty() && numbers && item.bytes)
        image.write(item.path, std::vector<std::uint8_t>(numbers->begin(), numbers->end()),
                    item.columns);
    else if (item.attribute.empty() && numbers)
        image.write(item.path, std::span<const std::int64_t>(*numbers), item.columns);
    else if (text)
        image.attribute(item.path, item.attribute, *text);
    else if (numbers)
        image.attribute(item.path, item.attribute, std::span<const std::int64_t>(*numbers));
    else if (reals && !reals->empty())
        image.attribute(item.path, item.attribute, reals->front());
}

} // namespace

ImageEdits::ImageEdits(const std::filesystem::path& file,
                       const std::vector<std::string>& attributes)
{
    collect(Hdf5Reader(file), "", attributes);
}

void ImageEdits::collect(const Hdf5Reader& reader,
                         const std::string& path,
                         const std::vector<std::string>& attributes)
{
    const std::string here = path.empty() ? "/" : path;
    for (const std::string& name : attributes) {
        if (!reader.hasAttribute(here, name)) continue;
        tried([&] { items_.push_back({here, name, 1, reader.text(here, name)}); });
        tried([&] { items_.push_back({here, name, 1, reader.integers(here, name)}); });
        if (items_.empty() || items_.back().attribute != name)
            items_.push_back({here, name, 1, std::vector{reader.number(here, name)}});
    }
    for (const std::string& name : reader.children(here)) {
        const std::string below = path + "/" + name;
        const std::size_t before = items_.size();
        if (!reader.has(below)) continue; // a link to another file
        tried([&] {
            items_.push_back({below, "", reader.columns(below), reader.doubles(below)});
            items_.back().value = reader.integers(below);
            items_.back().bytes = !reader.bytes(below).empty();
        });
        if (items_.size() == before) collect(reader, below, attributes);
    }
}

void ImageEdits::edit(std::size_t number, InputBytes& input)
{
    Item& item = items_[number];
    switch (input.byte() % 8) {
    case 0:
        items_.erase(items_.begin() + std::ptrdiff_t(number));
        return;
    case 1:
        editText(item.attribute.empty() ? item.path : item.attribute, input);
        return;
    case 2:
        swapType(item);
        return;
    case 3: { // a copy under another name
        Item copy = item;
        (copy.attribute.empty() ? copy.path : copy.attribute) += char('a' + input.byte() % 26);
        items_.push_back(std::move(copy));
        return;
    }
    default:
        if (auto* text = std::get_if<std::string>(&item.value))
            editText(*text, input);
        else if (auto* reals = std::get_if<std::vector<double>>(&item.value))
            editNumbers(item, *reals, input);
        else
            editNumbers(item, std::get<std::vector<std::int64_t>>(item.value), input);
    }
}

void ImageEdits::apply(InputBytes& input)
{
    while (!input.isEmpty() && !items_.empty()) edit(input.below(items_.size()), input);
}

void ImageEdits::write(const std::filesystem::path& folder,
                       const std::string& file,
                       const std::string& label) const
{
    Hdf5Image image;
    // Names that HDF5 does not take, or that stand twice, are left out.
    for (const Item& item : items_) tried([&] { writeItem(image, item); });
    image.save(OutputFolder(folder), file, label);
}

} // namespace fpm::fuzz
