#include "stability/MapReport.h"

#include "base/Format.h"

#include <algorithm>

namespace fpm {

namespace {

bool fails(const MapPoint& point)
{
    return point.result.outcome != Outcome::stable;
}

bool overSteps(const StabilityMap& map)
{
    return map.spec.x.parameter == parameter::timeStep;
}

/// What a step that is too long does; depth is a matter of the springs.
bool isUnstable(const MapPoint& point)
{
    return fails(point) && point.result.outcome != Outcome::penetration;
}

/// The first column of a row that ends so.
std::optional<std::size_t>
firstColumn(const StabilityMap& map, std::size_t row, bool (*ends)(const MapPoint&))
{
    const std::size_t columns = map.spec.x.values.size();
    for (std::size_t i = 0; i < columns; ++i)
        if (map.points[row * columns + i] && ends(*map.points[row * columns + i])) return i;
    return {};
}

std::string short3(double value)
{
    return toText(value, 3);
}

std::string failureText(const StabilityMap& map, const Onset& onset)
{
    const std::size_t row = onset.point / map.spec.x.values.size();
    return format("{}, {} {}", nameOf(map.points[onset.point]->result.outcome),
                  map.spec.y.parameter, short3(map.spec.y.values[row]));
}

std::string beginText(const Onset& onset)
{
    return format("failure begins at {} to {} of", short3(onset.least), short3(onset.most));
}

/// Whether what is predicted was seen to hold.
std::string boundText(const StabilityMap& map)
{
    const auto contact = onsetOfContact(map), both = onsetOfBoth(map);
    if (!contact) return {};
    if (contact->isBound())
        return format("; {} the bound from elements and contact, median {}", beginText(*contact),
                      short3(contact->median));
    std::string text = format("; 2 / sqrt(omega_e^2 + omega_c^2) alone is no safe bound here: "
                              "first failure at {} of it ({})",
                              short3(contact->least), failureText(map, *contact));
    if (!(both->least > contact->least)) return text;
    if (both->isBound())
        return text + format("; with omega_c dt <= 0.8 it is one: {} both", beginText(*both));
    return text
           + format("; nor is it with omega_c dt <= 0.8: first failure at {} of both ({})",
                    short3(both->least), failureText(map, *both));
}

/// Rows on both sides of a value, or at it.
std::vector<std::size_t> rowsBeside(const MapAxis& axis, double value)
{
    std::vector<std::size_t> rows;
    for (std::size_t j = 0; j < axis.values.size(); ++j) {
        const bool below = axis.values[j] <= value, above = axis.values[j] >= value;
        const bool last = j + 1 == axis.values.size() || axis.values[j + 1] > value;
        const bool first = j == 0 || axis.values[j - 1] < value;
        if ((below && last) || (above && first)) rows.push_back(j);
    }
    return rows;
}

bool isWithin(const MapAxis& axis, double value)
{
    return value >= axis.values.front() && value <= axis.values.back();
}

/// The least x that fails in the rows beside the case.
std::string nearestFailure(const StabilityMap& map, const OwnPoint& own)
{
    std::optional<std::size_t> column, row;
    for (const std::size_t j : rowsBeside(map.spec.y, own.y))
        if (const auto first = firstColumn(map, j, fails); first && (!column || *first < *column)) {
            column = first;
            row = j;
        }
    if (!column) return "; nothing fails in the rows beside it";
    const double x = map.spec.x.values[*column];
    const std::string where = format("{} {}, {} {}", map.spec.x.parameter, short3(x),
                                     map.spec.y.parameter, short3(map.spec.y.values[*row]));
    if (x <= own.x) return format("; not safe: {} fails already", where);
    return own.x > 0 ? format("; the first failure beside it is at {}, {} times as far", where,
                              short3(x / own.x))
                     : format("; the first failure beside it is at {}", where);
}

} // namespace

std::optional<Onset> onsetOf(const StabilityMap& map, double (*bound)(const Bounds&))
{
    if (!overSteps(map)) return {};
    const std::size_t columns = map.spec.x.values.size();
    std::vector<std::pair<double, std::size_t>> first;
    for (std::size_t j = 0; j < map.rows.size(); ++j)
        if (const auto i = firstColumn(map, j, isUnstable); i && map.rows[j])
            first.emplace_back(map.spec.x.values[*i] / bound(*map.rows[j]), j * columns + *i);
    if (first.empty()) return {};
    std::sort(first.begin(), first.end());
    return Onset{first.front().first, first[first.size() / 2].first, first.back().first,
                 first.front().second};
}

std::optional<Onset> onsetOfContact(const StabilityMap& map)
{
    return onsetOf(map, [](const Bounds& bounds) { return bounds.withContact; });
}

std::optional<Onset> onsetOfBoth(const StabilityMap& map)
{
    return onsetOf(map, [](const Bounds& bounds) { return bounds.both(); });
}

std::string conclusionOf(const StabilityMap& map)
{
    std::size_t failed = 0, predicted = 0, lost = 0;
    for (const auto& point : map.points) {
        failed += fails(*point);
        predicted += point->predictedStable;
        lost += point->predictedStable && fails(*point);
    }
    return format("{} points, {} fail; of {} predicted to be stable {}", map.points.size(), failed,
                  predicted, lost == 0 ? std::string("none does") : format("{} do", lost))
           + boundText(map);
}

std::string ownSentence(const StabilityMap& map)
{
    if (map.spec.scene != "case") return {};
    if (!map.own)
        return "this case is not on the map: its pairs or parts differ in what an axis gives all "
               "of them";
    const OwnPoint& own = *map.own;
    std::string text =
        format("this case: {} {}, {} {}{}: {}", map.spec.x.parameter, short3(own.x),
               map.spec.y.parameter, short3(own.y),
               isWithin(map.spec.x, own.x) && isWithin(map.spec.y, own.y) ? "" : ", off the map",
               nameOf(own.point.result.outcome));
    if (overSteps(map))
        text += format("; the step that is predicted to be stable is {}, {} times as far",
                       short3(own.bounds.both()), short3(own.bounds.both() / own.x));
    return text + nearestFailure(map, own);
}

} // namespace fpm
