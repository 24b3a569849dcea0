#include "run/RigidShare.h"

#include "mesh/Vector.h"

#include <algorithm>
#include <array>

namespace fpm {

namespace {

using Matrix = std::array<Point, 3>; // rows

/// w of J w = l by Cramer's rule; 0 where J is singular, as of a line.
Point solved(const Matrix& j, const Point& l)
{
    using namespace vector;
    const Point minors = cross(j[1], j[2]);
    const double determinant = dot(j[0], minors), trace = j[0][0] + j[1][1] + j[2][2];
    if (!(determinant > 1e-9 * trace * trace * trace)) return {0, 0, 0};
    // J is symmetric: its columns are its rows.
    return scaled({dot(l, minors), dot(l, cross(j[2], j[0])), dot(l, cross(j[0], j[1]))},
                  1 / determinant);
}

} // namespace

RigidShare rigidShare(const std::vector<Point>& places,
                      const std::vector<Point>& velocities,
                      const std::vector<double>& masses)
{
    using namespace vector;
    RigidShare out;
    double mass = 0;
    Point first{0, 0, 0}, momentum{0, 0, 0};
    for (std::size_t i = 0; i < masses.size(); ++i) {
        mass += masses[i];
        first = sum(first, scaled(places[i], masses[i]));
        momentum = sum(momentum, scaled(velocities[i], masses[i]));
        out.kinetic += 0.5 * masses[i] * dot(velocities[i], velocities[i]);
    }
    if (!(mass > 0)) return out;
    const Point centre = scaled(first, 1 / mass);
    Matrix inertia{};
    Point spin{0, 0, 0};
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const Point r = difference(places[i], centre);
        spin = sum(spin, scaled(cross(r, velocities[i]), masses[i]));
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                inertia[a][b] += masses[i] * ((a == b ? dot(r, r) : 0) - r[a] * r[b]);
    }
    out.rigid = 0.5 * dot(momentum, momentum) / mass + 0.5 * dot(spin, solved(inertia, spin));
    return out;
}

} // namespace fpm
