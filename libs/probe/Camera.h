#pragma once

#include "base/Types.h"

#include <array>

namespace fpm {

/// A point on the picture: x to the right, y downwards in pixels; greater depth is nearer the eye.
struct Projected {
    double x, y, depth;
};

/// Views the scene along a fixed direction and frames the given points.
class Camera
{
public:
    /// `towardsEye` need not be a unit vector; where `up` is parallel to it another is taken.
    /// Perspective is mild: the eye is 3 scene diagonals away.
    Camera(const Point& towardsEye, const Point& up, bool perspective);

    /// Grows the frame; positions that are not finite are passed over.
    void include(const Point& position);
    /// Height over width of the frame.
    double aspect() const;
    /// Centres the frame in a picture of width x height pixels, `margin` of them free all around.
    void fit(double width, double height, double margin);
    /// Valid after fit().
    Projected project(const Point& position) const;
    /// Components of a vector to the right, upwards and towards the eye.
    Point toView(const Point& vector) const;

private:
    double perspectiveFactor(double viewDepth) const;
    std::array<double, 2> extent() const;

    std::array<Point, 3> axes_{};
    bool perspective_;
    Point lower_, upper_;                          ///< of the frame in view components
    double scale_ = 1, centreX_ = 0, centreY_ = 0; ///< pixels per length; picture centre
};

} // namespace fpm
