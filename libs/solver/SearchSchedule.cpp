#include "solver/SearchSchedule.h"

#include "kernels/contact/Travel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fpm {

namespace {

/// Ways of both sides together, in reaches, until a pass is arranged again.
constexpr double nearness = 8;

std::vector<Index> sortedOnce(std::vector<Index> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// Blocks of contact nodes that some of them lie in.
std::vector<Index> blocksOf(std::vector<Index> numbers)
{
    for (Index& number : numbers) number /= travelBlock;
    return sortedOnce(std::move(numbers));
}

/// Largest way (0) or speed (1) in some blocks of one side plus that in some of the other.
double both(const SearchSchedule::Travel& travel,
            const std::vector<Index>& one,
            const std::vector<Index>& other,
            std::size_t which)
{
    const auto largest = [&](const std::vector<Index>& blocks) {
        double square = 0;
        for (const Index block : blocks)
            square = std::max(square, travel[2 * std::size_t(block) + which]);
        return std::sqrt(square);
    };
    return largest(one) + largest(other);
}

double longestDiagonal(const std::vector<Index>& faces, const SearchSchedule::Positions& positions)
{
    const std::size_t count = positions.size() / 3;
    double square = 0;
    for (std::size_t face = 0; face < faces.size(); face += 4)
        for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}}) {
            double sum = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double d = positions[c * count + std::size_t(faces[face + std::size_t(a)])]
                                 - positions[c * count + std::size_t(faces[face + std::size_t(b)])];
                sum += d * d;
            }
            square = std::max(square, sum);
        }
    return std::sqrt(square);
}

struct Box {
    Point low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

    void add(const SearchSchedule::Positions& positions, Index number)
    {
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = positions[c * (positions.size() / 3) + std::size_t(number)];
            low[c] = std::min(low[c], x);
            high[c] = std::max(high[c], x);
        }
    }
    bool isWithin(double distance, const Box& other) const
    {
        for (std::size_t c = 0; c < 3; ++c)
            if (low[c] > other.high[c] + distance || other.low[c] > high[c] + distance)
                return false;
        return true;
    }
};

/// How many of `most` steps a way leaves within a limit.
std::int64_t lasting(double way, double each, double limit, std::int64_t most)
{
    const double left = limit - way;
    return each * double(most) <= left ? most : std::int64_t(left / each);
}

} // namespace

SearchSchedule::SearchSchedule(const SolverData& data)
{
    for (std::size_t number = 0; number < data.pairs.size(); ++number) {
        const PairData& pair = data.pairs[number];
        if (pair.surface >= 0) continue;
        Pass pass;
        pass.number = number;
        pass.reach = pair.reach;
        for (const double thickness : pair.faceThickness)
            pass.thickness = std::max(pass.thickness, thickness);
        const auto numbered = [&](const std::vector<Index>& nodes, std::size_t count) {
            std::vector<Index> out;
            for (std::size_t i = 0; i < count; ++i)
                out.push_back(data.contactNumber[std::size_t(nodes[i])]);
            return out;
        };
        pass.faces = numbered(pair.faceNode, pair.faceNode.size());
        pass.target = sortedOnce(pass.faces);
        pass.contactor = numbered(pair.contactor, std::size_t(pair.nodeCount));
        pass.own = blocksOf(pass.contactor);
        pass.all = blocksOf(pass.target);
        passes_.push_back(std::move(pass));
    }
}

void SearchSchedule::arrange(std::size_t number, const Positions& positions)
{
    for (Pass& pass : passes_) {
        if (pass.number != number) continue;
        // A contactor pushes the corners of a face within reach, or deeper than which it is let go.
        // Since, it may have moved, and the corners both moved and moved apart.
        const double distance =
            longestDiagonal(pass.faces, positions) + pass.thickness + 3 * nearness * pass.reach;
        std::map<Index, Box> targets; // by blocks of contact nodes
        for (const Index node : pass.target) targets[node / travelBlock].add(positions, node);
        pass.way = 0;
        pass.blocks.clear();
        for (std::size_t first = 0; first < pass.contactor.size(); first += blockSize) {
            const auto begin = pass.contactor.begin() + std::ptrdiff_t(first),
                       end = begin
                             + std::min<std::ptrdiff_t>(blockSize, pass.contactor.end() - begin);
            Box box;
            for (auto node = begin; node != end; ++node) box.add(positions, *node);
            Block out{blocksOf({begin, end}), {}};
            for (const auto& [where, target] : targets)
                if (target.isWithin(distance, box)) out.near.push_back(where);
            pass.blocks.push_back(std::move(out));
        }
    }
}

std::vector<std::uint8_t> SearchSchedule::sharedBlocks(std::size_t number,
                                                       const std::vector<Index>& starts) const
{
    std::vector<std::uint8_t> shared;
    for (const Pass& pass : passes_) {
        if (pass.number != number || pass.own.empty() || pass.all.empty()) continue;
        shared.assign(std::size_t(std::max(pass.own.back(), pass.all.back())) + 1, 1);
        std::map<Index, std::set<std::ptrdiff_t>> threads; // of a block of contact nodes
        for (std::size_t b = 0; b < pass.blocks.size(); ++b) {
            const auto thread =
                std::upper_bound(starts.begin(), starts.end(), Index(b)) - starts.begin();
            for (const Index block : pass.blocks[b].own) threads[block].insert(thread);
            for (const Index block : pass.blocks[b].near) threads[block].insert(thread);
        }
        for (const auto& [block, those] : threads) shared[std::size_t(block)] = those.size() > 1;
    }
    return shared;
}

SearchSchedule::Plan SearchSchedule::plan(const Travel& travel, double timeStep, std::int64_t steps)
{
    Plan out{{}, steps};
    // Half as fast again leaves room for acceleration within the batch.
    const double time = 1.5 * timeStep;
    for (const Pass& pass : passes_) {
        Due due{pass.number, {}};
        const double each = both(travel, pass.own, pass.all, 1) * time;
        if (lasting(pass.way + both(travel, pass.own, pass.all, 0), each,
                    (nearness - 1) * pass.reach, steps)
            < steps) {
            out.steps = std::min(out.steps, lasting(0, each, pass.reach, steps));
            out.due.push_back(due);
            continue;
        }
        for (std::size_t number = 0; number < pass.blocks.size(); ++number) {
            const Block& block = pass.blocks[number];
            const double step = both(travel, block.own, block.near, 1) * time,
                         way = block.way + both(travel, block.own, block.near, 0);
            if (lasting(way, step, pass.reach, steps) == steps) continue;
            out.steps = std::min(out.steps, lasting(0, step, pass.reach, steps));
            due.blocks.push_back(Index(number));
        }
        if (!due.blocks.empty()) out.due.push_back(due);
    }
    out.steps = std::max<std::int64_t>(1, out.steps);
    if (!out.due.empty()) remember(travel, out.due);
    return out;
}

/// The positions are remembered anew: what is not searched keeps its way up to now.
void SearchSchedule::remember(const Travel& travel, const std::vector<Due>& due)
{
    for (Pass& pass : passes_) {
        pass.way += both(travel, pass.own, pass.all, 0);
        for (Block& block : pass.blocks) block.way += both(travel, block.own, block.near, 0);
        for (const Due& d : due)
            if (d.pass == pass.number)
                for (const Index number : d.blocks) pass.blocks[std::size_t(number)].way = 0;
    }
}

} // namespace fpm
