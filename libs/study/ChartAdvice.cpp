#include "study/ChartAdvice.h"

#include "base/Format.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// Two digits, or all before the point of numbers people still read: 0.35, 1.1, 14, 250.
std::string brief(double value)
{
    const bool isPlain = value >= 10 && value < 1e5;
    return isPlain ? toText(std::round(value)) : toText(value, 2);
}

std::string percent(double share)
{
    return brief(100 * share) + " %";
}

std::string costOf(const ChartSpec& chart, double cost)
{
    switch (chart.cost) {
    case CostKind::wall:
        return brief(cost) + " s";
    case CostKind::cpu:
        return brief(cost) + " s of CPU";
    default:
        return brief(cost) + " element-steps";
    }
}

class Adviser
{
public:
    Adviser(const ChartSpec& chart,
            const ChartProbe& probe,
            const Plan& plan,
            const std::vector<RungResult>& rungs,
            const ProbeResult& result)
        : chart_(chart),
          probe_(probe),
          plan_(plan),
          rungs_(rungs),
          result_(result)
    {
    }

    std::string text() const
    {
        const auto enough = cheapestThatHolds();
        return enough ? advice(*enough) : nothing();
    }

private:
    double error(std::size_t rung) const { return result_.error(rung, probe_.measure); }
    /// Within the tolerance; a rung without a result is not.
    bool holds(std::size_t rung) const
    {
        return result_.isReference[rung] || error(rung) <= chart_.tolerance;
    }
    bool isJudged(std::size_t rung) const
    {
        return !result_.isReference[rung] && std::isfinite(error(rung));
    }

    /// Rungs that differ in one ladder alone and are finer there.
    std::vector<std::size_t> finerThan(std::size_t rung) const
    {
        const std::vector<int>& mine = plan_.rungs[rung].values;
        std::vector<std::size_t> finer;
        for (std::size_t other = 0; other < plan_.rungs.size(); ++other) {
            const std::vector<int>& values = plan_.rungs[other].values;
            const auto [a, b] = std::mismatch(mine.begin(), mine.end(), values.begin());
            if (a == mine.end() || !std::equal(a + 1, mine.end(), b + 1) || *a < 0 || *b < 0)
                continue;
            const auto& coarseness = chart_.ladders[std::size_t(a - mine.begin())].coarseness;
            if (!coarseness.empty() && coarseness[std::size_t(*b)] < coarseness[std::size_t(*a)])
                finer.push_back(other);
        }
        return finer;
    }

    /// Whether a ladder says what would be finer.
    bool hasOrder(std::size_t rung) const
    {
        const std::vector<int>& values = plan_.rungs[rung].values;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i] >= 0 && !chart_.ladders[i].coarseness.empty()) return true;
        return false;
    }

    std::optional<std::size_t> cheapestThatHolds() const
    {
        std::optional<std::size_t> found;
        for (std::size_t rung = 0; rung < rungs_.size(); ++rung) {
            if (!isJudged(rung) || !holds(rung)) continue;
            const auto finer = finerThan(rung);
            const bool confirmed =
                std::all_of(finer.begin(), finer.end(), [&](std::size_t r) { return holds(r); });
            if (confirmed && (!found || cost(rung) < cost(*found))) found = rung;
        }
        return found;
    }

    std::optional<std::size_t> mostAccurate() const
    {
        std::optional<std::size_t> best;
        for (std::size_t rung = 0; rung < rungs_.size(); ++rung)
            if (isJudged(rung) && (!best || error(rung) < error(*best))) best = rung;
        return best;
    }

    double cost(std::size_t rung) const { return rungs_[rung].cost.median; }
    const std::string& label(std::size_t rung) const { return rungs_[rung].label; }
    std::string goal() const
    {
        return format("{} on {} ({})", percent(chart_.tolerance), probe_.name, measureText(probe_));
    }
    std::string against() const
    {
        return probe_.reference.kind == ReferenceSpec::Kind::finest
                   ? format("; errors against {}", result_.reference)
                   : "";
    }

    std::string advice(std::size_t rung) const
    {
        const auto text = format("for {} use {}: {}, error {}", goal(), label(rung),
                                 costOf(chart_, cost(rung)), percent(error(rung)));
        return text + confirmation(rung) + against();
    }

    std::string confirmation(std::size_t rung) const
    {
        std::vector<std::size_t> judged;
        bool isReference = false;
        for (const std::size_t finer : finerThan(rung))
            if (isJudged(finer))
                judged.push_back(finer);
            else
                isReference = true;
        if (judged.empty())
            return isReference      ? "; the only finer one is the reference itself"
                   : hasOrder(rung) ? "; no finer one is there to confirm it"
                                    : "";
        double most = 0, dearest = 0;
        for (const std::size_t finer : judged) {
            most = std::max(most, error(finer));
            dearest = std::max(dearest, cost(finer));
        }
        const auto figures =
            format("{} at {} times the cost", percent(most), brief(dearest / cost(rung)));
        return judged.size() == 1
                   ? format("; the finer {} holds it too, {}", label(judged.front()), figures)
                   : format("; the {} finer ones hold it too, at most {}", judged.size(), figures);
    }

    std::string nothing() const
    {
        const auto text = format("nothing here reaches {}: ", goal());
        const auto best = mostAccurate();
        if (!best) {
            const auto itself =
                std::find(result_.isReference.begin(), result_.isReference.end(), true);
            if (itself == result_.isReference.end()) return text + "no run has an error to judge";
            return text + "the only run with a result is the reference itself, "
                   + label(std::size_t(itself - result_.isReference.begin()));
        }
        const auto figures = format("{}: {} at {}", label(*best), percent(error(*best)),
                                    costOf(chart_, cost(*best)));
        if (!holds(*best)) return text + "the best is " + figures + against();
        const auto finer = finerThan(*best);
        const auto beyond =
            *std::find_if(finer.begin(), finer.end(), [&](std::size_t r) { return !holds(r); });
        const auto why = isJudged(beyond) ? format("but the finer {} {}: it crosses the reference "
                                                   "there and does not converge to it",
                                                   label(beyond), percent(error(beyond)))
                                          : format("but the finer {} has no result ({})",
                                                   label(beyond), causeOf(rungs_[beyond].state));
        return text + figures + ", " + why + against();
    }

    const ChartSpec& chart_;
    const ChartProbe& probe_;
    const Plan& plan_;
    const std::vector<RungResult>& rungs_;
    const ProbeResult& result_;
};

} // namespace

std::string conclusion(const ChartSpec& chart,
                       const ChartProbe& probe,
                       const Plan& plan,
                       const std::vector<RungResult>& rungs,
                       const ProbeResult& result)
{
    return Adviser(chart, probe, plan, rungs, result).text();
}

} // namespace fpm
