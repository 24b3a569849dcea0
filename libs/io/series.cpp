#include "base/Format.h"
#include "io/AtomicFile.h"
#include "io/Hdf5File.h"
#include "io/VtkHdf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace fpm {
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

} // namespace

std::vector<std::pair<std::string, double>> frameTimes(const std::filesystem::path& caseRoot)
{
    std::vector<std::pair<std::string, double>> times;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(caseRoot, error)) {
        const std::string name = entry.path().filename().string();
        const auto time = timeOf(name);
        if (time && isCompleteHdf5(entry.path() / "fields.vtkhdf")) times.emplace_back(name, *time);
    }
    std::ranges::sort(times, {}, [](const auto& one) { return std::pair(one.second, one.first); });
    return times;
}

void writeSeries(const std::filesystem::path& caseRoot)
{
    std::string files;
    for (const auto& [name, time] : frameTimes(caseRoot)) {
        files += files.empty() ? "\n" : ",\n";
        files += R"(    {"name": ")" + name + R"(/fields.vtkhdf", "time": )" + toText(time) + "}";
    }
    const std::string text =
        "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [" + files + "\n  ]\n}\n";
    writeFileAtomically(caseRoot / "case.vtkhdf.series", text);
    // ParaView before 5.12 knows the reader by this ending only.
    writeFileAtomically(caseRoot / "case.hdf.series", text);
}

std::string timeName(double time)
{
    // Times are sums or multiples of a step; twelve digits drop their rounding (0.1 + 0.2).
    constexpr int digits = 12;
    return time == 0 ? "0" : toText(time, digits);
}

} // namespace fpm
