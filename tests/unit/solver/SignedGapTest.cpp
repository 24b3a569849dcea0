#include "unit/solver/searchScene.h"

#include <gtest/gtest.h>

#include <random>

namespace fpm::test {
namespace {

double uniform(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// The skin of the cube [0, 1]^3, n x n faces a side, nodes shared.
Grid cube(Index n, bool inwards = false)
{
    Grid out;
    const auto node = [&](Point p) {
        for (std::size_t i = 0; i < out.points.size(); ++i) {
            double far = 0;
            for (std::size_t c = 0; c < 3; ++c)
                far = std::max(far, std::abs(out.points[i][c] - p[c]));
            if (far < 1e-9) return Index(i);
        }
        out.points.push_back(p);
        return Index(out.points.size()) - 1;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0})
            for (Index i = 0; i < n; ++i)
                for (Index j = 0; j < n; ++j) {
                    const auto at = [&](Index a, Index b) {
                        Point p;
                        p[axis] = side;
                        p[(axis + 1) % 3] = double(a) / double(n);
                        p[(axis + 2) % 3] = double(b) / double(n);
                        return node(p);
                    };
                    std::array<Index, 4> face{at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                              at(i, j + 1)};
                    if ((side == 0) != inwards) std::swap(face[1], face[3]);
                    out.faces.push_back(face);
                }
    return out;
}

/// Signed distance to the cube [0, 1]^3, negative inside.
double cubeDistance(const Point& p)
{
    double square = 0, deepest = -1e9;
    for (const double x : p) {
        const double out = std::max(-x, x - 1);
        square += out > 0 ? out * out : 0;
        deepest = std::max(deepest, out);
    }
    return deepest > 0 ? std::sqrt(square) : deepest;
}

/// Of points whose signed distance is known, how many a search gives no face or one where the gap
/// is another.
Index lost(ContactSearch search,
           const Grid& faces,
           const std::vector<Point>& queries,
           const std::function<double(const Point&)>& distance,
           double thickness = 0.25)
{
    SearchScene scene(faces.points, faces.faces, queries, search, thickness);
    scene.search();
    Index count = 0;
    for (Index query = 0; query < scene.queries(); ++query) {
        if (scene.faceOf(query) < 0) {
            ++count;
            continue;
        }
        const ContactPoint<double> now = scene.follow(query);
        const double exact = distance(queries[std::size_t(query)]);
        // Inside a ridge the depth is smaller, at a right angle by a tenth, at a corner of
        // three by an eighth.
        const bool blended = now.count > 1 && now.gap > exact && now.gap < exact * 6 / 7;
        count += now.beyond || (!blended && std::abs(now.gap - exact) > 1e-6);
    }
    return count;
}

/// Depth inside a ridge of faces normal to each other, by trying many weights.
double blendedDepth(std::array<double, 3> depths)
{
    double least = 1e300;
    for (int i = 0; i <= 200; ++i)
        for (int j = 0; i + j <= 200; ++j) {
            const double a = i / 200.0, b = j / 200.0, c = 1 - a - b;
            least =
                std::min(least, (a * depths[0] + b * depths[1] + c * depths[2])
                                    / (1 + 0.2 * std::pow(2, 15 / 16.0) * (a * b + b * c + c * a)));
        }
    return least;
}

TEST(SignedGap, OfACubeIsTheDistanceAtFacesEdgesAndCorners)
{
    // F4: nothing falls into a dead zone at a convex edge. Outside and inside, up to half a face.
    // Inside near an edge the depth is that of the blend.
    std::mt19937 random(61);
    std::vector<Point> queries;
    while (queries.size() < 4000) {
        const Point p{uniform(random, -0.2, 1.2), uniform(random, -0.2, 1.2),
                      uniform(random, -0.2, 1.2)};
        if (std::abs(cubeDistance(p)) < 0.06) queries.push_back(p);
    }
    const Grid faces = cube(4);
    SearchScene scene(faces.points, faces.faces, queries, ContactSearch::faces, 0.25);
    scene.search();
    Index edges = 0;
    for (Index query = 0; query < scene.queries(); ++query) {
        ASSERT_GE(scene.faceOf(query), 0);
        const ContactPoint<double> now = scene.follow(query);
        const Point& p = queries[std::size_t(query)];
        EXPECT_FALSE(now.beyond);
        const auto depth = [](double x) { return std::min(x, 1 - x); };
        if (now.count == 1) {
            EXPECT_NEAR(now.gap, cubeDistance(p), 1e-10);
        } else {
            EXPECT_NEAR(-now.gap, blendedDepth({depth(p[0]), depth(p[1]), depth(p[2])}), 1e-6);
            EXPECT_LE(-now.gap, -cubeDistance(p));
        }
        // The normal is the gradient of the distance.
        for (std::size_t c = 0; c < 3; ++c) {
            Point a = p, b = p;
            a[c] -= 1e-6;
            b[c] += 1e-6;
            const double slope = (cubeDistance(b) - cubeDistance(a)) / 2e-6;
            const double n = c == 0 ? now.normal.x : c == 1 ? now.normal.y : now.normal.z;
            if (cubeDistance(p) > 1e-4) {
                EXPECT_NEAR(n, slope, 1e-4);
            }
        }
        edges += now.gap > 0 && std::abs(now.normal.x) < 0.99 && std::abs(now.normal.y) < 0.99
                 && std::abs(now.normal.z) < 0.99;
    }
    EXPECT_GT(edges, 100);
    // The paper's search finds them too: squares, and the closest point is the toolkit's.
    EXPECT_EQ(lost(ContactSearch::closestParticle, faces, queries, cubeDistance), 0);
}

TEST(SignedGap, BehindAConcaveCornerIsTheResultantOfItsWalls)
{
    // F14: inside of a box; behind an edge or corner of it the gap is the distance to that.
    std::mt19937 random(62);
    std::vector<Point> queries;
    for (int i = 0; i < 2000; ++i)
        queries.push_back({uniform(random, -0.05, 0.06), uniform(random, -0.05, 0.06),
                           uniform(random, -0.05, 0.06)});
    const Grid faces = cube(4, true);
    SearchScene scene(faces.points, faces.faces, queries, ContactSearch::faces, 0.25);
    scene.search();
    for (Index query = 0; query < scene.queries(); ++query) {
        ASSERT_GE(scene.faceOf(query), 0);
        const ContactPoint<double> now = scene.follow(query);
        const double distance = -cubeDistance(queries[std::size_t(query)]);
        EXPECT_NEAR(now.gap, distance, 1e-10);
        if (distance < -1e-6) {
            const Point& p = queries[std::size_t(query)];
            EXPECT_NEAR(now.normal.x, p[0] < 0 ? p[0] / distance : 0, 1e-6);
            EXPECT_NEAR(now.normal.y, p[1] < 0 ? p[1] / distance : 0, 1e-6);
            EXPECT_NEAR(now.normal.z, p[2] < 0 ? p[2] / distance : 0, 1e-6);
        }
    }
    const auto outside = [](const Point& p) { return -cubeDistance(p); };
    EXPECT_EQ(lost(ContactSearch::closestParticle, faces, queries, outside), 0);
}

TEST(SignedGap, OnBordersAndCornersOfFacesRoundingDecidesNothing)
{
    // F5: points over edges and corners of a flat sheet, its rim too, moved by rounding.
    for (const double shift : {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-9, -1e-9})
        for (const double depth : {-0.01, -1e-6, 0.01}) {
            std::vector<Point> queries;
            for (int i = 0; i <= 8; ++i)
                for (int j = 0; j <= 8; ++j)
                    queries.push_back({i / 8.0 + shift, j / 8.0 + shift, depth});
            const Grid faces = grid(4, 4, [](double x, double y) { return Point{x, y, 0}; });
            SearchScene scene(faces.points, faces.faces, queries, ContactSearch::faces, 0.25);
            scene.search();
            for (Index query = 0; query < scene.queries(); ++query) {
                ASSERT_GE(scene.faceOf(query), 0) << "shift " << shift << " depth " << depth;
                const ContactPoint<double> now = scene.follow(query);
                EXPECT_FALSE(now.beyond);
                EXPECT_NEAR(now.gap, depth, 1e-12);
                EXPECT_NEAR(now.normal.z, 1, 1e-12);
            }
            EXPECT_EQ(lost(ContactSearch::closestParticle, faces, queries,
                           [&](const Point&) { return depth; }),
                      0);
        }
}

/// Two sheets beside one another, a gap of `crack` between their rims along x = 0.5.
Grid seam(double crack)
{
    Grid both;
    for (const double from : {0.0, 0.5}) {
        const Grid half = grid(2, 4, [&](double x, double y) {
            return Point{from + 0.5 * x + (from > 0 ? crack : 0), y, 0};
        });
        const Index first = Index(both.points.size());
        both.points.insert(both.points.end(), half.points.begin(), half.points.end());
        for (std::array<Index, 4> face : half.faces) {
            for (Index& node : face) node += first;
            both.faces.push_back(face);
        }
    }
    return both;
}

TEST(SignedGap, NoNodeFallsThroughASeamOfNodesThatAreNotShared)
{
    // F23: the rims touch, are apart by rounding, or by a crack no wider than the margin.
    std::mt19937 random(64);
    std::vector<Point> queries;
    for (int i = 0; i < 400; ++i)
        queries.push_back({0.5 + 0.2 * uniform(random, -1, 1) * (i % 2), uniform(random, 0, 1),
                           -uniform(random, 0.001, 0.02)});
    for (const double crack : {0.0, 1e-16, -1e-16, 1e-12, 0.001}) {
        const auto depth = [](const Point& p) { return p[2]; };
        EXPECT_EQ(lost(ContactSearch::faces, seam(crack), queries, depth), 0) << crack;
    }
    // The paper's search takes one of two particles in the same place, and its sheet alone.
    EXPECT_GT(
        lost(ContactSearch::closestParticle, seam(0), queries, [](const Point& p) { return p[2]; }),
        40);
}

TEST(SignedGap, EndsAtFreeEdges)
{
    // F15: beyond the rim by more than a hundredth of a face's width, and by more than the depth,
    // there is no contact.
    const Grid faces = grid(2, 2, [](double x, double y) { return Point{x, y, 0}; });
    for (const double depth : {0.001, 0.01})
        for (const double over : {0.004, 0.006, 0.012})
            for (const Point& out :
                 {Point{1, 0, 0}, Point{0, -1, 0}, Point{1, 1, 0}, Point{-1, -1, 0}}) {
                const Point p{out[0] > 0   ? 1 + over
                              : out[0] < 0 ? -over
                                           : 0.3,
                              out[1] > 0   ? 1 + over
                              : out[1] < 0 ? -over
                                           : 0.3,
                              -depth};
                SearchScene scene(faces.points, faces.faces, {p}, ContactSearch::faces, 0.25);
                scene.search();
                if (over > std::max(depth, 0.005)) {
                    EXPECT_EQ(scene.faceOf(0), noFace) << over << " at depth " << depth;
                    continue;
                }
                ASSERT_GE(scene.faceOf(0), 0) << over << " at depth " << depth;
                const ContactPoint<double> now = scene.follow(0);
                EXPECT_FALSE(now.beyond);
                EXPECT_NEAR(now.gap, -depth, 1e-12) << "what lies beyond the rim is no depth";
                EXPECT_NEAR(now.normal.z, 1, 1e-12);
            }
}

} // namespace
} // namespace fpm::test
