#pragma once

#include "model/Model.h"

namespace fpm {

/// Directions of one node that conditions hold or drive. Most nodes use the global axes; a node
/// with oblique conditions has axes of its own, chosen so that each is held, driven or free.
struct ImposedMotion {
    struct Clash {
        Index earlier = -1, later = -1; ///< conditions
        Index node = -1;                ///< the first of them
        Point direction{};
        bool oblique = false; ///< driven neither along nor across what the other imposes
        int nodes = 0;
    };

    std::vector<Axes> frames;   ///< oblique axes, each set once
    std::vector<Index> frameOf; ///< of each node, -1 global; empty: all global
    std::vector<Index> owner;   ///< [3 * node + axis]: condition that imposes it, -1 free
    std::vector<Clash> clashes; ///< of each condition with earlier ones: at most one

    const Axes& axesOf(Index node) const
    {
        const Index frame = frameOf.empty() ? -1 : frameOf[std::size_t(node)];
        return frame < 0 ? globalAxes : frames[std::size_t(frame)];
    }
    Index ownerOf(Index node, std::size_t axis) const
    {
        return owner[3 * std::size_t(node) + axis];
    }
};

/// Resolves all conditions that hold or drive; nodes of rigidFree parts, which their body moves,
/// are left out.
ImposedMotion imposedMotion(const Model& model);

/// True where a condition holds `direction` at rest: fixed, or driven by 0.
bool holds(const BoundaryCondition& condition, const Point& direction);

/// Whether two conditions impose the same along `direction`.
bool sameMotion(const BoundaryCondition& a, const BoundaryCondition& b, const Point& direction);

/// Conditions of rigidFree parts, by part: those of type fixed and symmetry that name it.
struct HeldBody {
    Axes axes = globalAxes;             ///< of `translations`
    std::array<bool, 3> translations{}; ///< held
    int turns = 3;                      ///< 3 free, 1 only about `axis`, 0 none; 2: refused
    Point axis{0, 0, 0};
};
HeldBody heldBody(const Model& model, Index part);

/// What describes the motion of a point: value in global components, or a turn. Path along
/// direction e: first * a(t) + second * b(t), a the amplitude and b 0, or a the sine and b 1 less
/// the cosine of the angle.
std::array<double, 2>
pathFactors(const BoundaryCondition& condition, const Point& position, const Point& direction);

} // namespace fpm
