#pragma once

#include "mesh/Mesh.h"
#include "model/Amplitude.h"

#include <array>
#include <string>
#include <vector>

namespace fpm {

/// Three orthonormal directions.
using Axes = std::array<Point, 3>;
inline constexpr Axes globalAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// constant/boundaryConditions, one entry, its set resolved to nodes.
struct BoundaryCondition {
    enum class Kind {
        fixed, ///< also symmetry: the normal is the first of its axes
        displacement,
        velocity,
        rotation, ///< by `angle` about `axis` through `centre`
        force,
        traction, ///< dead force per reference area of `sides`
        pressure, ///< on the current faces `sides`, value[0], positive presses
        gravity   ///< acceleration of `parts`
    } kind = Kind::fixed;
    std::string name;
    std::vector<Index> nodes; ///< ascending
    Index part = -1;          ///< the part, where the nodes are chosen by `part`
    bool mirror = false;      ///< symmetry: the scene goes on as its own mirror image
    std::array<bool, 3> constrains{false, false, false}; ///< components held or driven
    /// Displacement, velocity, total force, traction, pressure, acceleration; in `axes`.
    Point value{0, 0, 0};
    Amplitude amplitude;
    Axes axes = globalAxes;                         ///< what components and value refer to
    std::array<bool, 3> turns{false, false, false}; ///< rotations held, of a rigidFree part
    std::array<Point, 2> line{};                    ///< rotation: centre, unit axis
    double angle = 0;                               ///< rotation [degrees]
    std::vector<ElementSide> sides;                 ///< traction, pressure, force shared by area
    std::vector<Index> parts;                       ///< gravity

    bool isLoad() const { return kind >= Kind::force; }
    bool isGlobal() const { return axes == globalAxes; }
    /// `value` in global components.
    Point globalValue() const
    {
        Point out{0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t c = 0; c < 3; ++c) out[c] += value[i] * axes[i][c];
        return out;
    }
};

/// 0/initialConditions, one entry: velocity + spin x (position - centre).
struct InitialVelocity {
    std::string name;
    std::vector<Index> nodes;
    Point velocity{0, 0, 0};
    Point spin{0, 0, 0}; ///< [rad/time]
    Point centre{0, 0, 0};
    Index part = -1;      ///< the part, where the nodes are chosen by `part`
    bool rotates = false; ///< adds to other velocities; others set the velocity

    Point at(const Point& x) const
    {
        Point out = velocity;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
            out[c] += spin[d] * (x[e] - centre[e]) - spin[e] * (x[d] - centre[d]);
        }
        return out;
    }
};

} // namespace fpm
