#include "kernels/contact/lists/ReferenceDisplacement.h"

#include "parallel/CpuExecutor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace fpm {
namespace {

/// Contact nodes of two blocks around a point, with their positions as reference, then displaced.
class Nodes
{
public:
    explicit Nodes(double place) : position_(3 * count), velocity_(3 * count)
    {
        for (std::size_t i = 0; i < count; ++i) nodes_.push_back(Index(i));
        for (double& x : position_) x = place + width(random_);
        start_ = position_;
        for (Index i = 0; i < Index(count); ++i)
            StoreReferencePositions<DoublePrecision>{
                Index(count), nodes_.data(), position_.data(), count, origin_, offset_, nullptr}(i);
    }
    void move(double most)
    {
        std::uniform_real_distribution<double> way(-most, most);
        for (double& x : position_) x += way(random_);
    }
    double trueTravel(std::size_t block) const
    {
        double most = 0;
        for (std::size_t i = block * contactBlock; i < (block + 1) * contactBlock; ++i)
            most = std::max(most, std::hypot(position_[i] - start_[i],
                                             position_[count + i] - start_[count + i],
                                             position_[2 * count + i] - start_[2 * count + i]));
        return most;
    }
    double travel(Index block)
    {
        double out[2 * displacementValues];
        alignas(double) std::byte scratch[ReferenceDisplacement<DoublePrecision>::scratch()];
        ReferenceDisplacement<DoublePrecision>{
            Index(count), nodes_.data(), position_.data(), velocity_.data(),
            count,        origin_,       offset_,          out}(CpuTeam<64>(scratch), block);
        return std::sqrt(out[displacementValues * block]);
    }

private:
    static constexpr std::size_t count = 2 * contactBlock;
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> width{-1, 1};
    std::vector<Index> nodes_;
    std::vector<double> position_, velocity_, start_;
    double origin_[6];
    float offset_[3 * count];
};

TEST(ReferenceDisplacement, IsNeverTooSmallAndHardlyTooLargeAnywhere)
{
    for (const double place : {0.0, 1e4})
        for (const double way : {0.0, 1e-9, 1e-3, 1.0}) {
            Nodes nodes(place);
            nodes.move(way);
            for (const Index block : {0, 1}) {
                const double truth = nodes.trueTravel(std::size_t(block));
                EXPECT_GE(nodes.travel(block), truth) << place << " " << way;
                EXPECT_LT(nodes.travel(block), truth + 5e-7) << place << " " << way;
            }
        }
}

} // namespace
} // namespace fpm
