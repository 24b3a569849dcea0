#include "unit/solver/searchScene.h"

#include <gtest/gtest.h>

#include <random>

namespace fpm::test {
namespace {

double uniform(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A surface of ridges and valleys over x, and a bend along y.
double waves(double x, double y)
{
    return 0.06 * std::sin(9 * x) * (1 + 0.3 * y) + 0.02 * std::cos(5 * y);
}

TEST(Tracking, FollowsTheNearestFaceOverRidgesAndValleysWithoutASearch)
{
    // What the tracker follows is what trying all faces finds, step after step.
    std::mt19937 random(63);
    const Grid faces = grid(16, 8, [](double x, double y) { return Point{x, y, waves(x, y)}; });
    std::vector<Point> queries;
    for (int i = 0; i < 40; ++i) {
        const double x = uniform(random, 0.1, 0.9), y = uniform(random, 0.2, 0.8);
        queries.push_back({x, y, waves(x, y) + uniform(random, -0.015, 0.005)});
    }
    SearchScene scene(faces.points, faces.faces, queries, ContactSearch::faces, 0.1);
    scene.search();
    const double reach = scene.data().reach;
    for (Index query = 0; query < scene.queries(); ++query) {
        Point p = queries[std::size_t(query)];
        const double turn = uniform(random, 0, 6.28), dx = std::cos(turn), dy = std::sin(turn);
        for (int step = 0; step < 50; ++step) {
            p[0] += dx * 0.99 * reach / 50;
            p[1] += dy * 0.99 * reach / 50;
            scene.move(query, p);
            const ContactPoint<double> now = scene.follow(query);
            const Candidate<double> best = scene.bruteForce(query);
            if (best.face < 0) break; // over the rim, or out of reach
            EXPECT_LE(scene.squareTo(query, now.face[0]), 1.0000001 * best.point.square);
        }
    }
}

/// Four faces that meet at (0.5, 0.5), as high as `x` and `y` slopes make it there.
Grid hip(double x, double y)
{
    return grid(2, 2, [=](double u, double v) {
        return Point{u, v, -x * std::abs(u - 0.5) - y * std::abs(v - 0.5)};
    });
}

TEST(Tracking, InsideARidgeTheForceBelongsToAllFacesAsNear)
{
    // Below a ridge, its two faces; below a hipped top, four; off the middle by more than the blend
    // reaches, one, even by so little that the ridge is flat to the search.
    struct Case {
        double x, y, off;
        int faces;
    };
    for (const Case& c : {Case{0.2, 0, 0, 2},
                          {1e-3, 0, 0, 2},
                          {1e-7, 0, 0, 2},
                          {0.2, 0.1, 0, 4},
                          {1e-3, 2e-3, 0, 4},
                          {0.2, 0, 2e-3, 1},
                          {1e-3, 0, 1e-4, 1}}) {
        const Grid top = hip(c.x, c.y);
        const double v = c.y > 0 ? 0.5 : 0.3;
        SearchScene scene(top.points, top.faces, {{0.5 + c.off, v, -0.01}});
        scene.search();
        const ContactPoint<double> now = scene.follow(0);
        ASSERT_EQ(now.count, c.faces) << c.x << ' ' << c.y << ' ' << c.off;
        double weights = 0;
        Vec3<double> push{0, 0, 0};
        for (int k = 0; k < now.count; ++k) {
            weights += now.weight[k];
            push += now.push[k];
            if (c.faces == 2) {
                EXPECT_NEAR(now.weight[k], 0.5, 1e-9);
            }
        }
        EXPECT_NEAR(weights, 1, 1e-12);
        if (c.off > 0) continue; // in the planes of symmetry it is pushed along them
        EXPECT_NEAR(push.x, 0, 1e-9);
        EXPECT_NEAR(push.y, 0, 1e-9);
        EXPECT_NEAR(now.normal.z, 1, 1e-12);
    }
}

TEST(Tracking, SeesTheOppositeFlankOfAGroove)
{
    // F1: a V of 20 degrees, one long face on the left, eight on the right. A point goes from flank
    // to flank below its nodes; those nearest to it are on the right all the way.
    const double slope = std::tan(80 * 3.14159265358979 / 180);
    const Grid faces = grid(9, 2, [&](double x, double y) {
        const double at = x < 0.05 ? -0.2 : 0.2 * (9 * x - 1) / 8;
        return Point{at, y, slope * std::abs(at)};
    });
    const auto exact = [&](double x) {
        return 0.49 * std::cos(80 * 3.14159265358979 / 180)
               - std::abs(x) * std::sin(80 * 3.14159265358979 / 180);
    };
    SearchScene scene(faces.points, faces.faces, {{-0.1, 0.4, 0.49}}, ContactSearch::faces, 0.1);
    scene.search();
    double way = 0;
    for (double x = -0.1; x < 0.1; x += 0.0005, way += 0.0005) {
        scene.move(0, {x, 0.4, 0.49});
        if (2 * way > scene.data().reach) { // as often as in a run
            scene.search();
            way = 0;
        }
        if (std::abs(exact(x)) > 0.04) continue;
        ASSERT_GE(scene.faceOf(0), 0) << "at " << x;
        EXPECT_NEAR(scene.follow(0).gap, exact(x), 1e-9) << "at " << x;
    }
    SearchScene paper(faces.points, faces.faces, {{-0.1, 0.4, 0.49}},
                      ContactSearch::closestParticle, 0.1);
    paper.search();
    EXPECT_EQ(paper.faceOf(0), noFace) << "lost, though inside the left flank by " << exact(0.1);
}

/// Work of the penalty force over a path, and the change of k gap^2 / 2.
double lostWork(SearchScene& scene, const std::function<Point(double)>& way, int steps)
{
    double work = 0, first = 0, last = 0, most = 0;
    Point before{}, forceBefore{};
    for (int step = 0; step <= steps; ++step) {
        const Point p = way(double(step) / steps);
        scene.move(0, p);
        const ContactPoint<double> now = scene.follow(0);
        const double gap = std::min(now.gap, 0.0);
        Vec3<double> push{0, 0, 0};
        for (int k = 0; k < now.count; ++k) push += now.push[k];
        const Point force{-gap * push.x, -gap * push.y, -gap * push.z};
        last = 0.5 * gap * gap;
        most = std::max(most, last);
        if (step == 0)
            first = last;
        else
            for (std::size_t c = 0; c < 3; ++c)
                work += 0.5 * (force[c] + forceBefore[c]) * (p[c] - before[c]);
        before = p;
        forceBefore = force;
    }
    return (work + last - first) / most;
}

TEST(Tracking, ForceIsTheGradientOfAPotentialOverRidgesAndValleys)
{
    // F6: sliding over a roof and through a valley of 20 degrees creates and loses nothing; what is
    // left, of the step in which the normal changes, falls with the step.
    for (const double sign : {-1.0, 1.0}) {
        const Grid faces = grid(2, 2, [&](double x, double y) {
            return Point{x, y, sign * 0.176 * std::abs(x - 0.5)};
        });
        const auto way = [&](double s) {
            return Point{0.4 + 0.2 * s, 0.3 + 0.3 * s, sign * 0.01 - 0.02 + 0.003 * s};
        };
        std::vector<double> lost;
        for (const int steps : {200, 8000}) {
            SearchScene scene(faces.points, faces.faces, {way(0)}, ContactSearch::faces, 0.3);
            scene.search();
            lost.push_back(std::abs(lostWork(scene, way, steps)));
        }
        EXPECT_LT(lost[1], 1e-3) << (sign < 0 ? "roof" : "valley");
        EXPECT_LT(lost[1], 0.1 * lost[0] + 1e-6);
    }
}

} // namespace
} // namespace fpm::test
