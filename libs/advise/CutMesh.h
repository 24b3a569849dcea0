#pragma once

#include "advise/Mirror.h"

namespace fpm {

/// What is kept of a mesh: one side of each plane.
class Cut
{
public:
    /// `sides`: 1 keeps what lies beyond a plane, -1 what lies before it.
    Cut(const Mesh& mesh, std::vector<MirrorPlane> planes, std::vector<int> sides);

    const std::vector<MirrorPlane>& planes() const { return planes_; }
    int factor() const { return 1 << planes_.size(); } ///< of resultants, whole by kept
    bool keeps(const Point& point) const;
    bool keeps(const Mesh& mesh, Index element) const;
    std::size_t planesAt(const Point& point) const; ///< on how many planes a point lies
    bool isOn(std::size_t plane, const Point& point) const;
    /// The point, or its image on the side that is kept.
    Point kept(Point point) const;

private:
    double height(std::size_t plane, const Point& point) const;

    std::vector<MirrorPlane> planes_;
    std::vector<int> sides_;
    double tolerance_;
};

/// The elements kept with their nodes, moved onto the planes exactly, and the kept part of the
/// sets; renumbered, without contact surfaces.
Mesh cutMesh(const Mesh& mesh, const Cut& cut);

} // namespace fpm
