#include "io/Frames.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/FrameLabel.h"
#include "io/Hdf5File.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

namespace fpm {

namespace fs = std::filesystem;

namespace {

/// The value of a time folder's name, if the whole name is a finite number.
std::optional<double> timeOf(const std::string& name)
{
    double value = 0;
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// What a file says of itself behind its HDF5 part; a file of an older version, inside of it.
/// Nothing for a file that does not end as it should.
std::optional<FrameLabel> readLabel(const fs::path& file)
{
    const auto text = hdf5Label(file);
    if (!text) return std::nullopt;
    if (!text->empty()) return parseFrameLabel(*text);
    return FrameLabel{std::nullopt, Hdf5Reader(file).text("/fpm", "meshChecksum"), false};
}

/// HDF5's signature, and soon the names of the two groups at the top of all our files.
bool beginsAsFrame(const fs::path& file)
{
    constexpr std::string_view groups("VTKHDF\0\0fpm\0", 12);
    std::string head(4096, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(stream.gcount()));
    return head.starts_with("\x89HDF\r\n\x1a\n") && head.find(groups) != head.npos;
}

} // namespace

std::vector<FrameFile> listFrames(const fs::path& caseRoot)
{
    std::vector<FrameFile> frames;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(caseRoot, error)) {
        const std::string name = entry.path().filename().string();
        const auto time = timeOf(name);
        const auto file = entry.path() / "fields.vtkhdf";
        if (!time || !fs::exists(file, error)) continue;
        const auto label = readLabel(file);
        if (!label && !fs::exists(file, error)) continue; // moved away meanwhile
        if (!label)
            throw Error(ExitCode::mesh,
                        format("frame '{}' is cut short or no frame of ours", file.string()),
                        "move its time folder out of the case, or run fpmExplicit again");
        frames.push_back({{name, *time}, label->mark ? label->mark->runId : "", label->mesh});
    }
    std::ranges::sort(frames, {}, [](const FrameFile& one) {
        return std::pair(one.time.second, one.time.first);
    });
    return frames;
}

bool isFrame(const fs::path& caseRoot, const std::string& file)
{
    std::error_code error;
    const auto path = caseRoot / file;
    if (!fs::is_regular_file(fs::symlink_status(path, error))) return false;
    const auto text = hdf5Label(path);
    if (const auto mark = text ? parseFrameLabel(*text).mark : std::nullopt)
        return mark->file == file;
    return timeOf(fs::path(file).parent_path().string()) && beginsAsFrame(path);
}

std::string meshChecksumIn(const fs::path& file)
{
    if (!fs::exists(file)) return "";
    const auto label = readLabel(file);
    return label ? label->mesh : Hdf5Reader(file).text("/fpm", "meshChecksum");
}

std::string meshChecksumOf(const fs::path& caseRoot)
{
    return meshChecksumIn(caseRoot / "constant" / "mesh.vtkhdf");
}

bool meshHasIds(const fs::path& caseRoot)
{
    const auto text = hdf5Label(caseRoot / "constant" / "mesh.vtkhdf");
    return text && parseFrameLabel(*text).ids;
}

void writeSeries(const OutputFolder& theCase,
                 const std::string& runId,
                 const std::vector<std::string>& folders)
{
    std::string files;
    for (const std::string& name : folders) {
        files += files.empty() ? "\n" : ",\n";
        files += R"(    {"name": ")" + name + R"(/fields.vtkhdf", "time": )" + name + "}";
    }
    // ParaView asks for the version and the files and passes over the rest.
    const std::string run = runId.empty() ? "" : "  \"runId\": \"" + runId + "\",\n";
    const std::string text =
        "{\n  \"file-series-version\": \"1.0\",\n" + run + "  \"files\": [" + files + "\n  ]\n}\n";
    theCase.write("case.vtkhdf.series", text);
    // ParaView before 5.12 knows the reader by this ending only.
    theCase.write("case.hdf.series", text);
}

std::string timeName(double time)
{
    // Times are sums or multiples of a step; twelve digits drop their rounding (0.1 + 0.2).
    constexpr int digits = 12;
    return time == 0 ? "0" : toText(time, digits);
}

} // namespace fpm
