#include "solver/SearchSchedule.h"

#include "kernels/contact/Travel.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

std::vector<Index> blocksOf(const std::vector<Index>& numbers)
{
    std::vector<Index> blocks;
    for (const Index number : numbers) blocks.push_back(number / travelBlock);
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return blocks;
}

/// Root of the largest value [block][which].
double largest(const SearchSchedule::Travel& travel, const std::vector<Index>& blocks, int which)
{
    double square = 0;
    for (const Index block : blocks)
        square = std::max(square, travel[2 * std::size_t(block) + std::size_t(which)]);
    return std::sqrt(square);
}

} // namespace

SearchSchedule::SearchSchedule(const SolverData& data)
{
    for (std::size_t pass = 0; pass < data.pairs.size(); ++pass) {
        const PairData& pair = data.pairs[pass];
        if (pair.surface < 0)
            passes_.push_back(
                {pass, pair.reach, blocksOf(pair.contactorNumber), blocksOf(pair.faceNumber)});
    }
}

SearchSchedule::Plan SearchSchedule::plan(const Travel& travel, double timeStep, std::int64_t steps)
{
    Plan out{{}, steps};
    std::vector<double> way;
    std::vector<bool> due;
    for (const Pass& pass : passes_) {
        const auto both = [&](int which) {
            return largest(travel, pass.contactorBlocks, which)
                   + largest(travel, pass.targetBlocks, which);
        };
        // Half as fast again leaves room for acceleration within the batch.
        const double each = 1.5 * both(1) * timeStep;
        const auto lasting = [&](double done) {
            const double left = pass.reach - done;
            return each * double(steps) <= left ? steps : std::int64_t(left / each);
        };
        way.push_back(pass.way + both(0));
        due.push_back(lasting(way.back()) < steps);
        if (!due.back()) continue;
        out.due.push_back(pass.number);
        out.steps = std::min(out.steps, std::max<std::int64_t>(1, lasting(0)));
    }
    if (!out.due.empty())
        for (std::size_t k = 0; k < passes_.size(); ++k) passes_[k].way = due[k] ? 0 : way[k];
    return out;
}

void SearchSchedule::restart()
{
    for (Pass& pass : passes_) pass.way = 0;
}

} // namespace fpm
