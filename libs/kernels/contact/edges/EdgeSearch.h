#pragma once

#include "kernels/contact/broad/CellLists.h"
#include "kernels/contact/edges/EdgePassView.h"

namespace fpm {

/// Enters a segment into the cell of its middle, as InsertFace; its box is wide enough to be found
/// from any query point of a segment near it.
template <class Numbers>
struct InsertEdge {
    EdgePassView<Numbers> edges;
    CellLists cells;

    FPM_KERNEL void operator()(Index number) const
    {
        if (number < edges.firstTarget) return;
        const ContactPassView<Numbers>& pass = edges.pass;
        const std::size_t from = std::size_t(edges.nodeOf(number, 0)),
                          to = std::size_t(edges.nodeOf(number, 1));
        const double margin = double(pass.margin(number)) + double(edges.queryHalf);
        double middle[3], widest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = double(pass.position[c * pass.nodeStride + from]),
                         y = double(pass.position[c * pass.nodeStride + to]);
            middle[c] = 0.5 * (x + y);
            const double wide = (x < y ? y - x : x - y) + 2 * margin;
            widest = wide > widest ? wide : widest;
        }
        cells.insertBox(number, middle, widest);
    }
};

/// The nearest partners of a segment, by distance and number.
template <class Work>
struct NearestEdges {
    Index best[edgeSlots];
    Work square[edgeSlots];
    int count = 0;
    bool crowded = false;

    FPM_KERNEL bool has(Index number) const
    {
        for (int k = 0; k < count; ++k)
            if (best[k] == number) return true;
        return false;
    }
    FPM_KERNEL void add(Index number, Work distance)
    {
        if (has(number)) return;
        if (count == edgeSlots) {
            crowded = true;
            if (!isNearer(number, distance, count - 1)) return;
        } else
            ++count;
        int at = count - 1;
        for (; at > 0 && isNearer(number, distance, at - 1); --at) {
            best[at] = best[at - 1];
            square[at] = square[at - 1];
        }
        best[at] = number;
        square[at] = distance;
    }

private:
    FPM_KERNEL bool isNearer(Index number, Work distance, int than) const
    {
        return distance < square[than] || (distance == square[than] && number < best[than]);
    }
};

/// Finds the segments that may cross a segment before the next search, and enters them into its
/// slots; a pair that is closed keeps its slot.
template <class Numbers>
struct FindEdges {
    using Work = typename Numbers::Work;
    EdgePassView<Numbers> edges;
    CellLists cells;

    FPM_KERNEL void operator()(Index own) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        const Index from = edges.nodeOf(own, 0), to = edges.nodeOf(own, 1);
        const EdgeSegment<Work> a = edges.segment(own, from);
        const Work length = squareRoot(dot(a.along, a.along));
        const int points = 1 + int(length / (Work(2) * edges.queryHalf));
        NearestEdges<Work> found;
        for (int k = 0; k < points; ++k) {
            const double share = (k + 0.5) / points;
            double x[3];
            for (std::size_t c = 0; c < 3; ++c)
                x[c] = (1 - share) * double(pass.position[c * pass.nodeStride + std::size_t(from)])
                       + share * double(pass.position[c * pass.nodeStride + std::size_t(to)]);
            cells.forEachEntry(
                x, [&](Index number)
                       __attribute__((always_inline)) { test(own, from, a, number, found); });
        }
        if (found.crowded) atomicAdd64(pass.counts + countCrowded, 1);
        enter(own, found);
    }

private:
    FPM_KERNEL void test(Index own,
                         Index origin,
                         const EdgeSegment<Work>& a,
                         Index number,
                         NearestEdges<Work>& found) const
    {
        if (number <= own || !edges.pass.mayTouch(own, number)) return;
        const EdgeSegment<Work> b = edges.segment(number, origin);
        const EdgeCrossing<Work> at(a, b);
        // Almost parallel ones and wedges that turn away may not close before the next search.
        if (!at.mayHold()) return;
        const Work reach = edges.pass.reach, square = distanceSquare(a, b);
        Work most = reach;
        if (at.gap < 0) { // as ContactPassView::margin
            const Work deep = edges.deepest(own, number) + Work(0.5) * reach;
            most = deep > reach ? deep : reach;
        }
        if (square <= most * most) found.add(number, square);
    }
    FPM_KERNEL void enter(Index own, const NearestEdges<Work>& found) const
    {
        const ContactPassView<Numbers>& pass = edges.pass;
        unsigned placed = 0;
        for (Index i = own; i < pass.contactorCount; i += pass.nodeCount) {
            if (pass.face[i] < 0) continue;
            int match = 0;
            while (match < found.count && found.best[match] != pass.face[i]) ++match;
            if (match < found.count)
                placed |= 1u << match;
            else if (edges.state[i] != edgesClosed)
                pass.face[i] = noFace;
        }
        int match = 0;
        for (Index i = own; i < pass.contactorCount; i += pass.nodeCount) {
            if (pass.face[i] >= 0) continue;
            while (match < found.count && (placed >> match & 1)) ++match;
            if (match == found.count) return;
            pass.face[i] = found.best[match++];
            edges.state[i] = edgesApart;
        }
        while (match < found.count && (placed >> match & 1)) ++match;
        if (match < found.count) atomicAdd64(pass.counts + countCrowded, 1);
    }
};

} // namespace fpm
