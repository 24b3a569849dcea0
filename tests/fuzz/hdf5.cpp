#include "fuzz/InputBytes.h"
#include "fuzz/tried.h"
#include "io/Checksum.h"
#include "io/Hdf5File.h"
#include "io/Hdf5Seal.h"
#include "support/TemporaryFolder.h"

#include <algorithm>
#include <array>

// A file of any bytes behind a checksum that fits is read or refused: what is checked before HDF5,
// by it and behind it. The input is a list of changes of the bytes of a small file.

using namespace fpm;

namespace {

/// The bytes that are changed: every kind of array, attribute, group and link that we write.
struct Base {
    test::TemporaryFolder folder;
    std::string bytes;

    Base()
    {
        Hdf5Image image;
        image.write("/a/b/doubles", std::vector<double>{1, 2.5, -3, 1e300, 0, 7}, 3);
        image.write("/a/floats", std::vector<float>{0.5F, 2});
        image.write("/a/integers", std::vector<std::int32_t>{1, -2, 3});
        image.write("/a/bytes", std::vector<std::uint8_t>{12, 255});
        image.write("/a/empty", std::vector<std::int32_t>{});
        image.attribute("/a", "text", "hello");
        image.attribute("/", "nothing", "");
        image.attribute("/c", "list", std::vector<std::int64_t>{1, 2, std::int64_t(1) << 40});
        image.attribute("/c", "number", 0.1);
        for (const std::string name : {"1", "2", "3", "4", "5", "6", "7", "8", "9"})
            image.link("/links/" + name, "../other.vtkhdf", "/a");
        image.save(OutputFolder(folder.path()), "file.h5");
        bytes = test::readBytes(file());
        bytes.resize(bytes.size() - sizeof(hdf5::Seal));
    }
    std::filesystem::path file() const { return folder / "file.h5"; }
};

void change(std::string& bytes, fuzz::InputBytes& input)
{
    const std::size_t place = input.below(bytes.size() + 1), left = bytes.size() - place;
    const auto put = [&](std::uint64_t value, std::size_t count) {
        for (std::size_t i = 0; i < std::min(count, left); ++i, value >>= 8)
            bytes[place + i] = char(value);
    };
    constexpr std::array<std::uint64_t, 8> special{0,      1,       0xff,    0x7fff,
                                                   0xffff, 1 << 16, 1 << 30, ~std::uint64_t(0)};
    const std::uint8_t kind = input.byte();
    switch (kind % 8) {
    case 0:
        return put(special[input.byte() % special.size()], 8);
    case 1:
        return put(special[input.byte() % special.size()], 4);
    case 2:
        return put(special[input.byte() % special.size()], 2);
    case 3:
        return put(input.number(2), 2);
    case 4: { // what stands elsewhere
        const std::string piece = bytes.substr(input.below(bytes.size() + 1), 1 + kind / 8);
        std::copy_n(piece.begin(), std::min(piece.size(), left),
                    bytes.begin() + std::ptrdiff_t(place));
        return;
    }
    case 5:
        if (kind == 5) bytes.resize(place);
        return;
    default:
        put(input.byte(), 1);
    }
}

void writeSealed(const std::filesystem::path& file, std::string bytes)
{
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(bytes)));
    for (const std::byte one : hdf5::makeSeal(checksum.value())) bytes += char(one);
    test::writeBytes(file, bytes);
}

void readEverything(const Hdf5Reader& reader, const std::string& path, int depth)
{
    using fuzz::tried;
    const std::string here = path.empty() ? "/" : path;
    for (const std::string name : {"text", "nothing", "list", "number"}) {
        tried([&] { reader.hasAttribute(here, name); });
        tried([&] { reader.text(here, name); });
        tried([&] { reader.integers(here, name); });
        tried([&] { reader.number(here, name); });
    }
    tried([&] { reader.columns(here); });
    tried([&] { reader.doubles(here); });
    tried([&] { reader.integers(here); });
    tried([&] { reader.bytes(here); });
    if (depth == 0) return;
    tried([&] {
        for (const std::string& name : reader.children(here))
            readEverything(reader, path + "/" + name, depth - 1);
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    constexpr int depth = 4;
    static const Base base;
    fuzz::InputBytes input(data, size);
    std::string bytes = base.bytes;
    while (!input.isEmpty()) change(bytes, input);
    writeSealed(base.file(), bytes);
    fuzz::tried([&] { readEverything(Hdf5Reader(base.file()), "", depth); });
    return 0;
}
