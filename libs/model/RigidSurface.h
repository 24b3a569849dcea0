#pragma once

#include "base/Types.h"
#include "model/Amplitude.h"

#include <string>

namespace fpm {

/// An analytic rigid target of system/contactDict: no mesh, exact gap and normal. It moves without
/// turning.
struct RigidSurface {
    enum class Kind { plane, cylinder, sphere } kind = Kind::plane;
    std::string name;
    Point point{0, 0, 0}; ///< of the plane; first end of the cylinder's axis; centre
    Point axis{0, 0, 1};  ///< unit: normal out of the half space; direction of the axis
    double length = 0;    ///< of the cylinder
    double radius = 0;
    bool infinite = false; ///< a cylinder that goes on beyond its ends
    bool inside = false;   ///< bodies are within the cylinder or sphere, as in a pipe
    enum class Motion { none, displacement, velocity } motion = Motion::none;
    Point value{0, 0, 0};
    Amplitude amplitude;

    /// Distance of a point from the surface before it moves, < 0 inside it; +infinity beside the
    /// ends of a cylinder. Normal there, out of the rigid body.
    double gap(const Point& point, Point& normal) const;
};

} // namespace fpm
