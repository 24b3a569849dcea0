#include "probe/Camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(const Point& a)
{
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

} // namespace

Camera::Camera(const Point& towardsEye, const Point& up, bool perspective)
    : perspective_(perspective)
{
    const Point eye = unit(towardsEye);
    Point right = cross(up, eye);
    if (dot(right, right) < 1e-8 * dot(up, up))
        right = cross(std::abs(eye[1]) < 0.9 ? Point{0, 1, 0} : Point{0, 0, 1}, eye);
    axes_ = {unit(right), unit(cross(eye, right)), eye};
    const double infinite = std::numeric_limits<double>::infinity();
    lower_ = {infinite, infinite, infinite};
    upper_ = {-infinite, -infinite, -infinite};
}

Point Camera::toView(const Point& vector) const
{
    return {dot(axes_[0], vector), dot(axes_[1], vector), dot(axes_[2], vector)};
}

void Camera::include(const Point& position)
{
    const Point view = toView(position);
    if (!std::isfinite(view[0] + view[1] + view[2])) return;
    for (std::size_t k = 0; k < 3; ++k) {
        lower_[k] = std::min(lower_[k], view[k]);
        upper_[k] = std::max(upper_[k], view[k]);
    }
}

double Camera::perspectiveFactor(double viewDepth) const
{
    const Point size{upper_[0] - lower_[0], upper_[1] - lower_[1], upper_[2] - lower_[2]};
    const double distance = 3 * std::sqrt(dot(size, size));
    return distance / (distance - (viewDepth - (lower_[2] + upper_[2]) / 2));
}

std::array<double, 2> Camera::extent() const
{
    if (lower_[0] > upper_[0]) return {1, 1};
    const double nearest = perspective_ ? perspectiveFactor(upper_[2]) : 1;
    const double least = 1e-12 + 1e-3 * (upper_[0] - lower_[0] + upper_[1] - lower_[1]);
    return {nearest * std::max(least, upper_[0] - lower_[0]),
            nearest * std::max(least, upper_[1] - lower_[1])};
}

double Camera::aspect() const
{
    return extent()[1] / extent()[0];
}

void Camera::fit(double width, double height, double margin)
{
    scale_ = std::min((width - 2 * margin) / extent()[0], (height - 2 * margin) / extent()[1]);
    centreX_ = width / 2;
    centreY_ = height / 2;
}

Projected Camera::project(const Point& position) const
{
    const Point view = toView(position);
    const double factor = perspective_ ? perspectiveFactor(view[2]) : 1;
    // the perspective factor itself is linear over the picture of a plane, so it serves as depth
    return {centreX_ + scale_ * factor * (view[0] - (lower_[0] + upper_[0]) / 2),
            centreY_ - scale_ * factor * (view[1] - (lower_[1] + upper_[1]) / 2),
            perspective_ ? factor : view[2]};
}

} // namespace fpm
