#pragma once

#include "base/Archive.h"
#include "solver/Solver.h"

namespace fpm {

/// Friction of a pair while it slides as a whole, against that of Coulomb: mean forces over windows
/// of slip in one direction, far beyond what its tangential springs give. Bodies that
/// stick, hammer or slip in all directions at once are not judged.
class Sliding
{
public:
    void sample(double time, const PairStatus& status, const ContactPair& pair);
    bool isJudged() const { return windows_ >= fewestWindows; }
    /// Friction delivered over that of Coulomb's law.
    double ratio() const { return asked_ > 0 ? delivered_ / asked_ : 1; }
    /// End of the window that delivered least of it.
    double worstTime() const { return worstTime_; }
    void keep(Archive& archive);

private:
    struct Window {
        double path = 0, duration = 0, asked = 0;
        Point slip{0, 0, 0}, impulse{0, 0, 0};
    };
    void close();

    static constexpr int fewestWindows = 5;
    static constexpr double manySprings = 20;    ///< path of a window in elastic slips
    static constexpr double straightShare = 0.9; ///< displacement over path
    static constexpr double together = 0.7;      ///< mean slip over mean of its lengths

    Window window_;
    double lastTime_ = -1;
    int windows_ = 0;
    double asked_ = 0, delivered_ = 0;
    double worst_ = 1e300, worstTime_ = -1;
};

} // namespace fpm
