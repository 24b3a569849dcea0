#include "probe/Times.h"

#include "base/Error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

namespace fpm {

namespace {

double parseTime(std::string_view text)
{
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw Error(ExitCode::commandLine,
                    "option -time: '" + std::string(text) + "' is not a time",
                    "write numbers, ranges first:last or latestTime, separated by commas");
    return value;
}

double tolerance(const std::vector<FrameTime>& all, double time)
{
    double spacing = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < all.size(); ++i)
        spacing = std::min(spacing, all[i].second - all[i - 1].second);
    return std::isfinite(spacing) ? 0.02 * spacing : 1e-3 * std::abs(time);
}

} // namespace

TimeSelection parseTimes(std::string_view text)
{
    TimeSelection selection;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view item = text.substr(0, comma);
        const std::size_t colon = item.find(':');
        if (item == "latestTime")
            selection.latest = true;
        else if (colon != std::string_view::npos)
            selection.ranges.emplace_back(parseTime(item.substr(0, colon)),
                                          parseTime(item.substr(colon + 1)));
        else
            selection.times.push_back(parseTime(item));
        if (comma == text.size()) return selection;
        text.remove_prefix(comma + 1);
    }
}

ChosenFrames chooseFrames(const std::vector<FrameTime>& all, const TimeSelection& selection)
{
    ChosenFrames chosen;
    std::set<std::size_t> numbers;
    for (const double time : selection.times) {
        const auto nearest = std::min_element(all.begin(), all.end(), [&](auto& a, auto& b) {
            return std::abs(a.second - time) < std::abs(b.second - time);
        });
        if (nearest == all.end() || std::abs(nearest->second - time) > tolerance(all, time))
            chosen.missing.push_back(time);
        else
            numbers.insert(std::size_t(nearest - all.begin()));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const auto& [first, last] : selection.ranges) {
            const double slack = tolerance(all, all[i].second);
            if (all[i].second >= first - slack && all[i].second <= last + slack) numbers.insert(i);
        }
    }
    if (selection.latest && !all.empty()) numbers.insert(all.size() - 1);
    for (const std::size_t number : numbers) chosen.frames.push_back(all[number]);
    return chosen;
}

} // namespace fpm
