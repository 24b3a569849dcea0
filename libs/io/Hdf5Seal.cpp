#include "io/Hdf5Seal.h"

#include "base/Error.h"
#include "io/Checksum.h"
#include "io/Hdf5File.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace fpm {
namespace {

constexpr std::array<char, 8> plainMark{'f', 'p', 'm', 's', 'u', 'm', '1', '\n'};
/// With a label the last byte is its length.
constexpr std::array<char, 7> labelMark{'f', 'p', 'm', 's', 'u', 'm', '2'};

/// Length of the label before the seal; nothing where there is no seal.
std::optional<std::size_t> readSeal(const InputFile& file, hdf5::Seal& seal)
{
    if (!file.isReadable() || file.size() < seal.size()
        || !file.read(file.size() - seal.size(), seal))
        return std::nullopt;
    if (std::memcmp(seal.data(), plainMark.data(), plainMark.size()) == 0) return 0;
    if (std::memcmp(seal.data(), labelMark.data(), labelMark.size()) != 0) return std::nullopt;
    const auto length = std::to_integer<std::size_t>(seal[labelMark.size()]);
    if (file.size() < seal.size() + length) return std::nullopt;
    return length;
}

/// The label of this length; nothing on a read error.
std::optional<std::string> readLabel(const InputFile& file, std::size_t length)
{
    std::string label(length, '\0');
    const std::uint64_t place = file.size() - sizeof(hdf5::Seal) - length;
    if (!file.read(place, std::as_writable_bytes(std::span(label)))) return std::nullopt;
    return label;
}

} // namespace

namespace hdf5 {

Seal makeSeal(std::uint64_t checksum, std::size_t labelLength)
{
    if (labelLength > std::numeric_limits<std::uint8_t>::max())
        throw Error(ExitCode::internal, "the label of a file is too long");
    Seal seal;
    std::memcpy(seal.data(), plainMark.data(), plainMark.size());
    if (labelLength > 0) {
        std::memcpy(seal.data(), labelMark.data(), labelMark.size());
        seal[labelMark.size()] = std::byte(labelLength);
    }
    std::memcpy(seal.data() + plainMark.size(), &checksum, sizeof checksum);
    return seal;
}

std::string verifySeal(const InputFile& file)
{
    file.requireReadable();
    Seal seal;
    const auto labelLength = readSeal(file, seal);
    if (!labelLength) refuse(file.name(), "it does not end as a complete file of ours does");
    constexpr std::uint64_t blockSize = 1 << 20;
    const std::uint64_t end = file.size() - seal.size();
    std::vector<std::byte> buffer(std::size_t(std::min(blockSize, end)));
    Checksum checksum;
    for (std::uint64_t offset = 0; offset < end; offset += blockSize) {
        const auto block = std::span(buffer).first(std::size_t(std::min(blockSize, end - offset)));
        if (!file.read(offset, block)) refuse(file.name(), "read error");
        checksum.add(block);
    }
    if (makeSeal(checksum.value(), *labelLength) != seal)
        refuse(file.name(), "it is damaged: its checksum does not match");
    const auto label = readLabel(file, *labelLength);
    if (!label) refuse(file.name(), "read error");
    return *label;
}

void refuse(const std::filesystem::path& file, const std::string& reason)
{
    throw Error(ExitCode::mesh, "cannot read '" + file.string() + "': " + reason,
                "files that are cut short, edited or made by other programs are refused; write it "
                "again with the utility that made it");
}

} // namespace hdf5

std::optional<std::string> hdf5Label(const std::filesystem::path& file)
{
    const InputFile input(file);
    hdf5::Seal seal;
    const auto length = readSeal(input, seal);
    return length ? readLabel(input, *length) : std::nullopt;
}

} // namespace fpm
