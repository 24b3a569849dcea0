#include "advise/RigidFit.h"

#include "mesh/Vector.h"

#include <cmath>

namespace fpm {

namespace {

using Rows = std::array<Point, 3>;

Point centre(const std::vector<Point>& points)
{
    Point sum{0, 0, 0};
    for (const Point& p : points) sum = vector::sum(sum, p);
    return vector::scaled(sum, 1 / double(points.size()));
}

Point turned(const Rows& rotation, const Point& p)
{
    return {vector::dot(rotation[0], p), vector::dot(rotation[1], p), vector::dot(rotation[2], p)};
}

/// Rotation about `w` through its length, after `before`.
Rows turnedOn(const Point& w, const Rows& before)
{
    const double angle = vector::length(w);
    if (angle == 0) return before;
    const Point axis = vector::scaled(w, 1 / angle);
    const double c = std::cos(angle), s = std::sin(angle);
    Rows out;
    for (std::size_t column = 0; column < 3; ++column) {
        const Point v{before[0][column], before[1][column], before[2][column]};
        const Point across = vector::cross(axis, v);
        const double along = (1 - c) * vector::dot(axis, v);
        for (std::size_t row = 0; row < 3; ++row)
            out[row][column] = c * v[row] + s * across[row] + along * axis[row];
    }
    return out;
}

/// Solves a symmetric 3 x 3 system by Cramer's rule; 0 where it is singular.
Point solved(const Rows& m, const Point& b)
{
    const Point c = vector::cross(m[1], m[2]);
    const double determinant = vector::dot(m[0], c);
    if (determinant == 0) return {0, 0, 0};
    const Point d = vector::cross(m[2], m[0]), e = vector::cross(m[0], m[1]);
    Point out;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = (c[i] * b[0] + d[i] * b[1] + e[i] * b[2]) / determinant;
    return out;
}

} // namespace

double RigidFit::deviation(const std::vector<Point>& before, const std::vector<Point>& now)
{
    const Point from = centre(before), to = centre(now);
    double square = 0;
    constexpr int iterations = 20;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        Rows m{};
        Point torque{0, 0, 0};
        square = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Point x = turned(rotation_, vector::difference(before[i], from));
            const Point r = vector::difference(vector::difference(now[i], to), x);
            torque = vector::sum(torque, vector::cross(x, r));
            square += vector::dot(r, r);
            const double size = vector::dot(x, x);
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b) m[a][b] += (a == b ? size : 0) - x[a] * x[b];
        }
        const Point w = solved(m, torque);
        rotation_ = turnedOn(w, rotation_);
        if (vector::length(w) < 1e-14) break;
    }
    return std::sqrt(square / double(before.size()));
}

} // namespace fpm
