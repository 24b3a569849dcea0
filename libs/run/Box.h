#pragma once

#include "base/Types.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace fpm {

/// The smallest box along the axes that holds some points; empty at first.
struct Box {
    static constexpr double far = std::numeric_limits<double>::max();
    Point least{far, far, far}, most{-far, -far, -far};

    void take(const Point& p)
    {
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], p[c]);
            most[c] = std::max(most[c], p[c]);
        }
    }
    bool holds(const Point& p) const
    {
        for (std::size_t c = 0; c < 3; ++c)
            if (p[c] < least[c] || p[c] > most[c]) return false;
        return true;
    }
    bool meets(const Box& other) const
    {
        for (std::size_t c = 0; c < 3; ++c)
            if (most[c] < other.least[c] || other.most[c] < least[c]) return false;
        return true;
    }
};

/// visit(a, b), a < b, for each two boxes that meet: sorted along x, so that many bodies cost no
/// square of their number.
template <class Visit>
void forBoxesThatMeet(const std::vector<Box>& boxes, const Visit& visit)
{
    std::vector<std::size_t> order(boxes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].least[0] < boxes[b].least[0]; });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            if (boxes[order[j]].least[0] > boxes[order[i]].most[0]) break;
            if (boxes[order[i]].meets(boxes[order[j]]))
                visit(std::min(order[i], order[j]), std::max(order[i], order[j]));
        }
}

} // namespace fpm
