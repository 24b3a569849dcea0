#pragma once

#include "kernels/contact/narrow/Tracking.h"
#include "parallel/CpuExecutor.h"
#include "solver/contact/PassView.h"
#include "solver/contact/searchPass.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>

namespace fpm::test {

/// Faces and free points without a mesh: results of the search and of the tracker for a point, and
/// of a test of every face.
class SearchScene
{
public:
    using Pair = ContactPassView<DoublePrecision>;

    /// One pass from target nodes, faces of them and query points.
    SearchScene(std::vector<Point> nodes,
                const std::vector<std::array<Index, 4>>& faces,
                const std::vector<Point>& queries,
                ContactSearch search = ContactSearch::faces,
                double thickness = 1)
        : points_(std::move(nodes)),
          search_(search)
    {
        double area = 0;
        for (const auto& face : faces) {
            data_.faceNode.insert(data_.faceNode.end(), face.begin(), face.end());
            data_.faceThickness.push_back(thickness);
            data_.faceStiffness.push_back(1);
            area += areaOf(face);
        }
        data_.search = search;
        data_.meanFaceSize = std::sqrt(area / double(faces.size()));
        addTopology(data_, points_);
        for (const Point& query : queries) {
            data_.contactor.push_back(Index(points_.size()));
            points_.push_back(query);
        }
        data_.nodeCount = Index(queries.size());
        data_.ownFaceStart.assign(queries.size() + 1, 0); // no faces of their own: no filter
        fields_ = std::make_unique<PassFields>(data_, hostMemory(), NumberTypes{});
        upload();
    }

    void search()
    {
        CpuExecutor<64> executor(1, 0);
        searchPass(executor, view(), cellsOf(data_, *fields_), search_ == ContactSearch::faces,
                   {nullptr, nullptr, nullptr});
    }

    /// The tracker at the present positions.
    ContactPoint<double> follow(Index query)
    {
        const Pair pair = view();
        const auto now = FaceTracker<DoublePrecision>{pair, cellsOf(data_, *fields_)}.follow(query);
        fields_->face.data()[query] = now.face[0];
        fields_->xi.data<double>()[query] = now.xi[0];
        fields_->eta.data<double>()[query] = now.eta[0];
        return now;
    }

    /// Nearest partner of all faces, by trying each.
    Candidate<double> bruteForce(Index query)
    {
        const Pair pair = view();
        Candidate<double> best{noFace, {}, 0};
        for (Index face = 0; face < pair.faceCount; ++face) {
            Candidate<double> other;
            if (isPartner(pair, query, face, other) && (best.face < 0 || isNearer(other, best)))
                best = other;
        }
        return best;
    }

    std::vector<Index> around(Index face, int corner)
    {
        std::vector<Index> out;
        view().visitAround(face, corner, [&](Index other) {
            out.push_back(other);
            return true;
        });
        return out;
    }
    Index faceOf(Index query) const { return fields_->face.data()[query]; }
    double squareTo(Index query, Index face)
    {
        const Pair pair = view();
        return closestPoint(pair.corners(face, pair.contactor[query]), 0.0, 0.0).square;
    }
    Index queries() const { return data_.nodeCount; }
    void move(Index query, const Point& to)
    {
        points_[std::size_t(data_.contactor[std::size_t(query)])] = to;
        upload();
    }
    void moveNode(Index node, const Point& to)
    {
        points_[std::size_t(node)] = to;
        upload();
    }
    const ContactPassSetup& data() const { return data_; }
    std::int64_t count(PassCount which) const { return fields_->counts.data()[which]; }

private:
    Pair view()
    {
        Pair pair = surfaceView<DoublePrecision>(data_, *fields_);
        pair.position = position_.data();
        pair.velocity = velocity_.data();
        pair.nodeStride = points_.size();
        return pair;
    }
    void upload()
    {
        position_ = planesOf(points_);
        velocity_.assign(position_.size(), 0);
    }
    double areaOf(const std::array<Index, 4>& face) const
    {
        const auto at = [&](std::size_t k) {
            const Point& p = points_[std::size_t(face[k])];
            return Vec3<double>{p[0], p[1], p[2]};
        };
        const Vec3<double> n = cross(at(2) - at(0), at(3) - at(1));
        return 0.5 * std::sqrt(dot(n, n));
    }

    std::vector<Point> points_;
    ContactSearch search_;
    ContactPassSetup data_;
    std::unique_ptr<PassFields> fields_;
    std::vector<double> position_, velocity_;
};

/// A grid of nx x ny faces over [0, 1]^2, numbered x fastest, each point moved by `shape`.
struct Grid {
    std::vector<Point> points;
    std::vector<std::array<Index, 4>> faces;
};
inline Grid grid(Index nx, Index ny, const std::function<Point(double, double)>& shape)
{
    Grid out;
    for (Index j = 0; j <= ny; ++j)
        for (Index i = 0; i <= nx; ++i)
            out.points.push_back(shape(double(i) / double(nx), double(j) / double(ny)));
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i) {
            const Index a = i + (nx + 1) * j;
            out.faces.push_back({a, a + 1, a + nx + 2, a + nx + 1});
        }
    return out;
}

} // namespace fpm::test
