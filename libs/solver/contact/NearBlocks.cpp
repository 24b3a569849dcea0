#include "solver/contact/NearBlocks.h"

#include "base/Error.h"
#include "kernels/contact/broad/Search.h"
#include "kernels/contact/lists/ListCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fpm {

namespace {

std::vector<Index> sortedOnce(std::vector<Index> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// Blocks of contact nodes that some of them lie in.
std::vector<Index> blocksWith(std::vector<Index> numbers)
{
    for (Index& number : numbers) number /= contactBlock;
    return sortedOnce(std::move(numbers));
}

double longestDiagonal(const std::vector<Index>& faces, const NearBlocks::Positions& positions)
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

    void add(const NearBlocks::Positions& positions, Index number)
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

} // namespace

NearBlocks::NearBlocks(const SolverSetUp& data)
{
    for (std::size_t number = 0; number < data.contact.passes.size(); ++number) {
        const ContactPassSetup& setUp = data.contact.passes[number];
        if (setUp.surface >= 0) continue;
        Pass pass;
        pass.number = number;
        pass.reach = setUp.reach;
        for (const double thickness : setUp.faceThickness)
            pass.thickness = std::max(pass.thickness, thickness);
        const auto numbered = [&](const std::vector<Index>& nodes, std::size_t count) {
            std::vector<Index> out;
            for (std::size_t i = 0; i < count; ++i)
                out.push_back(data.contact.numberOf[std::size_t(nodes[i])]);
            return out;
        };
        if (setUp.ofEdges) {
            std::vector<Index> ends, faces;
            for (std::size_t i = 0; i < setUp.edgeNode.size(); i += 6) {
                const Index a = setUp.edgeNode[i], b = setUp.edgeNode[i + 1];
                ends.insert(ends.end(), {a, b});
                if (Index(i / 6) >= setUp.firstTarget) faces.insert(faces.end(), {a, b, b, a});
            }
            pass.nodesEach = 2;
            pass.faces = numbered(faces, faces.size());
            pass.contactor = numbered(ends, 2 * std::size_t(setUp.nodeCount));
        } else {
            pass.faces = numbered(setUp.faceNode, setUp.faceNode.size());
            pass.contactor = numbered(setUp.contactor, std::size_t(setUp.nodeCount));
        }
        pass.target = sortedOnce(pass.faces);
        pass.allOwn = blocksWith(pass.contactor);
        pass.allTarget = blocksWith(pass.target);
        const std::ptrdiff_t block = contactBlock * std::ptrdiff_t(pass.nodesEach);
        for (auto first = pass.contactor.begin(); first != pass.contactor.end();) {
            const auto end = first + std::min<std::ptrdiff_t>(block, pass.contactor.end() - first);
            const std::vector<Index> own = blocksWith({first, end});
            pass.own.blocks.insert(pass.own.blocks.end(), own.begin(), own.end());
            pass.own.starts.push_back(Index(pass.own.blocks.size()));
            first = end;
        }
        passes_.push_back(std::move(pass));
    }
}

void NearBlocks::rebuild(std::size_t place, const Positions& positions)
{
    Pass& pass = passes_[place];
    // A contactor pushes the corners of a face within reach outside or a thickness inside. Since
    // the rebuild it may have moved, and the corners both moved and moved apart.
    const double distance = longestDiagonal(pass.faces, positions) + pass.thickness
                            + 3 * ListCheck::rebuildDistance * pass.reach;
    std::map<Index, Box> targets; // by blocks of contact nodes
    for (const Index node : pass.target) targets[node / contactBlock].add(positions, node);
    pass.near = {};
    const std::size_t block = contactBlock * pass.nodesEach;
    for (std::size_t first = 0; first < pass.contactor.size(); first += block) {
        Box box;
        for (std::size_t i = first; i < std::min(first + block, pass.contactor.size()); ++i)
            box.add(positions, pass.contactor[i]);
        for (const auto& [where, target] : targets)
            if (target.isWithin(distance, box)) pass.near.blocks.push_back(where);
        pass.near.starts.push_back(Index(pass.near.blocks.size()));
    }
}

void NearBlocks::restore(std::size_t place,
                         const std::vector<Index>& starts,
                         const std::vector<Index>& blocks)
{
    Pass& pass = passes_[place];
    // No rebuild so far: nothing is near anything.
    const bool none = std::ranges::all_of(starts, [](Index start) { return start == 0; });
    const auto isBlock = [&](Index block) {
        return std::ranges::binary_search(pass.allTarget, block);
    };
    const bool whole = starts.size() == pass.own.starts.size() && starts.front() == 0
                       && std::ranges::is_sorted(starts)
                       && std::size_t(starts.back()) <= blocks.size()
                       && std::all_of(blocks.begin(), blocks.begin() + starts.back(), isBlock);
    if (!whole)
        throw Error(ExitCode::checkpoint, "the lists of near contact nodes do not fit the model");
    pass.near = {};
    if (none) return;
    pass.near.starts = starts;
    pass.near.blocks.assign(blocks.begin(), blocks.begin() + starts.back());
}

std::vector<std::uint8_t> NearBlocks::sharedBlocks(std::size_t place,
                                                   const std::vector<Index>& starts) const
{
    const Pass& pass = passes_[place];
    if (pass.allOwn.empty() || pass.allTarget.empty()) return {};
    std::vector<std::uint8_t> shared(
        std::size_t(std::max(pass.allOwn.back(), pass.allTarget.back())) + 1, 1);
    std::map<Index, std::set<std::ptrdiff_t>> threads; // of a block of contact nodes
    for (const BlockLists* lists : {&pass.own, &pass.near})
        for (std::size_t b = 0; b + 1 < lists->starts.size(); ++b) {
            const auto thread =
                std::upper_bound(starts.begin(), starts.end(), Index(b)) - starts.begin();
            for (Index k = lists->starts[b]; k < lists->starts[b + 1]; ++k)
                threads[lists->blocks[std::size_t(k)]].insert(thread);
        }
    for (const auto& [block, those] : threads) shared[std::size_t(block)] = those.size() > 1;
    return shared;
}

} // namespace fpm
