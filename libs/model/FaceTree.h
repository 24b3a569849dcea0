#pragma once

#include "mesh/Mesh.h"

#include <functional>
#include <span>

namespace fpm {

/// Finds the face nearest to a point in a tree of bounding boxes: as quick for faces of very
/// unequal size, and for points far away, as for even ones. A face counts as its two triangles.
class FaceTree
{
public:
    /// At least one side.
    FaceTree(const Mesh& mesh, std::span<const ElementSide> sides);

    struct Hit {
        std::size_t face = 0; ///< number in `sides`
        Point point{};        ///< of the face, nearest to the queried point
        double distance = 0;
        double height = 0; ///< distance along the outward normal; < 0 behind the face
    };
    /// Of faces equally near (at an edge or corner) the one whose normal points best along the line
    /// to `point`; where that does not decide, as for a point on the edge, the one most opposed to
    /// `outward`, the outward direction of the point's own surface.
    Hit nearest(const Point& point, const Point& outward = {0, 0, 0}) const;
    /// The same among the hits that `accepts` says yes to; distance infinite where there is none.
    using Accept = std::function<bool(const Hit&)>;
    Hit nearest(const Point& point, const Point& outward, const Accept& accepts) const;

private:
    struct Box {
        Point lower, upper;
    };
    struct Branch {
        Box box;
        std::size_t first = 0, count = 0; ///< faces order_[first ...]; count 0: two children
        std::size_t child = 0;            ///< the first of them; the second follows it
    };
    struct Best;

    void split(std::size_t branch, std::size_t first, std::size_t count);
    Box boxOf(std::size_t first, std::size_t count) const;
    void tryFace(std::size_t face,
                 const Point& point,
                 const Point& outward,
                 const Accept& accepts,
                 Best& best) const;

    std::vector<std::array<Point, 4>> corners_;
    std::vector<Point> normals_, centres_;
    std::vector<std::size_t> order_;
    std::vector<Branch> branches_;
    double tolerance_ = 0; ///< lengths that differ by less are equal
};

} // namespace fpm
