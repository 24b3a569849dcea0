#pragma once

#include "base/Types.h"

#include <array>
#include <vector>

namespace fpm {

/// How far a cloud of points is from a rigid motion of itself. Keeps its last rotation as the start
/// for the next call, so that frames may turn a body as far as they like, a radian at a time.
class RigidFit
{
public:
    /// Root mean square distance of `now` from the best rigid motion of `before` (Gauss-Newton on
    /// the rotation).
    double deviation(const std::vector<Point>& before, const std::vector<Point>& now);

private:
    std::array<Point, 3> rotation_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< rows
};

} // namespace fpm
