#include "kernels/contact/broad/CellLists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace fpm {
namespace {

/// Square faces of several sizes in a cube, entered into so few lists that each holds many cells.
class Crowd
{
public:
    Crowd(Index faces, double width, std::uint32_t lists, Index levels)
        : thickness_(std::size_t(faces), 0.1f),
          head_(std::size_t(lists + std::uint32_t(levels)) + 1, -1),
          entries_(std::size_t(faces)),
          cells{head_.data(), entries_.data(), lists - 1, 0.5, levels}
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-width, width);
        for (Index face = 0; face < faces; ++face) {
            const double size = face % 100 == 0 ? 6 : face % 10 == 0 ? 1.5 : 0.5;
            const double x = place(random), y = place(random), z = place(random);
            for (const auto& [dx, dy] : {std::pair{0., 0.}, {size, 0.}, {size, size}, {0., size}}) {
                faceNode_.push_back(Index(faceNode_.size()));
                points_.push_back({x + dx, y + dy, z});
            }
        }
        for (int query = 0; query < 200; ++query)
            points_.push_back({place(random), place(random), place(random)});
        for (std::size_t c = 0; c < 3; ++c)
            for (const std::array<double, 3>& point : points_) position_.push_back(point[c]);
        pair.faceCount = faces;
        pair.faceNode = faceNode_.data();
        pair.faceThickness = thickness_.data();
        pair.reach = 0.1;
        pair.position = position_.data();
        pair.nodeStride = points_.size();
        for (Index face = 0; face < faces; ++face) InsertFace<DoublePrecision>{pair, cells}(face);
    }
    Index queries() const { return Index(points_.size()) - 4 * pair.faceCount; }
    Index node(Index query) const { return 4 * pair.faceCount + query; }

    std::vector<Index> found(Index query) const
    {
        std::vector<Index> out;
        cells.forEachFace(pair, node(query), [&](Index face) { out.push_back(face); });
        return out;
    }
    /// Width of its box with its margin; its cells are no wider.
    double widest(Index face) const
    {
        const std::size_t first = 4 * std::size_t(face);
        return points_[first + 2][0] - points_[first][0] + 2 * pair.margin(face);
    }
    /// Distance from the box of a face, in the direction where it is largest.
    double outside(Index query, Index face) const
    {
        double most = -1e300;
        for (std::size_t c = 0; c < 3; ++c) {
            double low = 1e300, high = -1e300;
            for (std::size_t k = 0; k < 4; ++k) {
                const double x = points_[4 * std::size_t(face) + k][c];
                low = std::min(low, x);
                high = std::max(high, x);
            }
            const double x = points_[std::size_t(node(query))][c];
            most = std::max({most, low - x, x - high});
        }
        return most;
    }

private:
    std::vector<std::array<double, 3>> points_;
    std::vector<double> position_;
    std::vector<float> thickness_;
    std::vector<Index> faceNode_, head_;
    std::vector<CellEntry> entries_;

public:
    ContactPassView<DoublePrecision> pair{};
    CellLists cells;
};

TEST(CellLists, EveryFaceNearAPointIsFoundOnceHoweverManyCellsShareAList)
{
    for (const Index levels : {1, 3, 5}) {
        const Crowd crowd(2000, 5, 16, levels);
        for (Index query = 0; query < crowd.queries(); ++query) {
            const std::vector<Index> found = crowd.found(query);
            const std::set<Index> once(found.begin(), found.end());
            EXPECT_EQ(once.size(), found.size()) << "a face twice";
            for (Index face = 0; face < crowd.pair.faceCount; ++face) {
                const bool near = crowd.outside(query, face) <= crowd.pair.margin(face);
                EXPECT_TRUE(!near || once.count(face)) << "face " << face << " lost";
            }
        }
    }
}

TEST(CellLists, FacesOfForeignCellsAreNotTried)
{
    const Crowd crowd(2000, 20, 16, 5);
    for (Index query = 0; query < crowd.queries(); ++query)
        for (const Index face : crowd.found(query))
            EXPECT_LT(crowd.outside(query, face), 2 * crowd.widest(face)) << "face " << face;
}

} // namespace
} // namespace fpm
