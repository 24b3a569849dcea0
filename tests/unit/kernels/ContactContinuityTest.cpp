#include "unit/kernels/oneContactor.h"
#include "unit/kernels/rotated.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace fpm {
namespace {

using namespace test;

/// The neighbours of faces given by their corners.
Faces connected(std::vector<Index> faceNode)
{
    Faces out;
    const Index corners = Index(faceNode.size());
    out.nextAround.resize(faceNode.size());
    out.neighbour.assign(faceNode.size(), freeEdge);
    std::map<Index, std::vector<Index>> around;
    for (Index k = 0; k < corners; ++k) around[faceNode[std::size_t(k)]].push_back(k);
    for (const auto& [node, at] : around)
        for (std::size_t k = 0; k < at.size(); ++k)
            out.nextAround[std::size_t(at[k])] = at[(k + 1) % at.size()];
    const auto end = [&](Index edge) {
        return faceNode[std::size_t(edge / 4 * 4 + (edge + 1) % 4)];
    };
    for (Index a = 0; a < corners; ++a)
        for (const Index b : around[end(a)])
            if (a / 4 != b / 4 && end(b) == faceNode[std::size_t(a)])
                out.neighbour[std::size_t(a)] = b;
    out.faceNode = std::move(faceNode);
    return out;
}

/// A surface around a corner at the origin in which `count` faces meet, with a second ring where
/// there are four. Node 0 is the contactor.
struct Surface {
    std::vector<V> nodes{{0, 0, 0}};
    Faces faces;
};
Surface fan(int count)
{
    Surface out;
    out.nodes.push_back({0, 0, 0});
    const double turn = 2 * M_PI / count;
    for (int k = 0; k < count; ++k) {
        out.nodes.push_back({std::cos(k * turn), std::sin(k * turn), 0});
        out.nodes.push_back(
            {1.5 * std::cos((k + 0.5) * turn), 1.5 * std::sin((k + 0.5) * turn), 0});
    }
    std::vector<Index> corners;
    for (int k = 0; k < count; ++k)
        for (const int node : {1, 2 + 2 * k, 3 + 2 * k, 2 + 2 * ((k + 1) % count)})
            corners.push_back(Index(node));
    out.faces = connected(std::move(corners));
    return out;
}

struct Shape {
    const char* name;
    double (*height)(double x, double y);
    bool jagged; ///< heights of nodes random besides
};
const Shape shapes[] = {{"flat", [](double, double) { return 0.0; }, false},
                        {"valley", [](double x, double) { return std::abs(x); }, false},
                        {"ridge", [](double x, double) { return -std::abs(x); }, false},
                        {"saddle", [](double x, double y) { return x * y; }, false},
                        {"dent", [](double x, double y) { return x * x + y * y; }, false},
                        {"bump", [](double x, double y) { return -x * x - y * y; }, false},
                        {"jagged", [](double, double) { return 0.0; }, true}};

/// A random place deep in a random surface of a kind, near its corner.
class RandomScene
{
public:
    RandomScene(const Shape& shape, int count, std::mt19937& random) : random_(random)
    {
        surface = fan(count);
        const double slope = 0.02 * std::pow(10, any()), stretch = std::pow(50, 0.5 * any());
        for (std::size_t k = 1; k < surface.nodes.size(); ++k) {
            V& p = surface.nodes[k];
            p.z = slope * (shape.height(p.x, p.y) + (shape.jagged ? any() : 0));
            p.x = stretch * (p.x + 0.1 * any()); // faces of up to 1 : 50
            p.y += 0.1 * any();
        }
        depth = std::pow(10, -2.5 + 1.5 * any()) * std::min(1.0, stretch);
        const double off = std::pow(10, -4 + 3.5 * any()) * std::min(1.0, stretch);
        surface.nodes[0] = surface.nodes[1] + V{off * any(), off * any(), -depth};
    }
    double any() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

    Surface surface;
    double depth = 0;

private:
    std::mt19937& random_;
};

/// Largest change of the force on a contactor in a small motion, to stiffness times motion.
double steepest(const Shape& shape, int count, double friction, int scenes)
{
    std::mt19937 random(1);
    double most = 0;
    for (int n = 0; n < scenes; ++n) {
        RandomScene scene(shape, count, random);
        OneContactor one(friction, scene.surface.nodes, Index(n % count), scene.surface.faces,
                         {.ownNormal = {0, 0, -1}});
        std::vector<V> motion(scene.surface.nodes.size(), V{0, 0, 0});
        const V along{scene.any(), scene.any(), 0};
        for (int k = 0; k < 5; ++k) { // friction builds up
            motion[0] = (0.02 * scene.depth) * along;
            one.move(motion);
        }
        const double little = scene.depth * std::pow(10, -5 + 2 * scene.any());
        for (int k = 0; k < 10 && one.face() >= 0; ++k) {
            motion[0] = little * V{scene.any(), scene.any(), scene.any()};
            const V before = one.force(0);
            one.move(motion);
            if (one.face() < 0) break;                                 // over the rim
            const double change = size(one.force(0) - before) - 1e-11; // of fixed-point sums
            most = std::max(most, change / (normalStiffness * size(motion[0])));
        }
    }
    return most;
}

/// F5, F6: where the projection point enters the space of an edge or a corner, or another face
/// becomes the nearest, the force changes no faster than elsewhere. A spring alone gives 1.
/// Friction at most doubles that; inside a ridge, where the normal turns within a fifth of the
/// depth, three times.
TEST(ContactContinuity, AForceChangesByFewTimesStiffnessTimesMotion)
{
    for (const Shape& shape : shapes)
        for (const int count : {3, 4, 5, 6})
            for (const double friction : {0.0, 0.2})
                EXPECT_LT(steepest(shape, count, friction, 3000), 3.5)
                    << shape.name << " of " << count << " faces, friction " << friction;
}

/// Work of the force on a contactor around a closed path near the corner, to the energy of its
/// spring.
double workAround(const Shape& shape, int count, int steps)
{
    std::mt19937 random(2);
    double most = 0;
    for (int n = 0; n < 20; ++n) {
        RandomScene scene(shape, count, random);
        scene.surface.nodes[0] = scene.surface.nodes[1] + V{0, 0, -0.02};
        OneContactor one(0, scene.surface.nodes, Index(n % count), scene.surface.faces,
                         {.ownNormal = {0, 0, -1}});
        const double radius = 0.01 * (1 + scene.any()), rise = 0.01 * scene.any();
        const auto place = [&](int k) {
            const double turn = 2 * M_PI * k / steps;
            return V{radius * (std::cos(turn) - 1), radius * std::sin(turn), rise * std::sin(turn)};
        };
        std::vector<V> motion(scene.surface.nodes.size(), V{0, 0, 0});
        double work = 0;
        for (int k = 1; k <= steps; ++k) {
            motion[0] = place(k) - place(k - 1);
            const V before = one.force(0);
            one.move(motion);
            work += 0.5 * dot(before + one.force(0), motion[0]);
        }
        most = std::max(most, std::abs(work) / one.springEnergy());
    }
    return most;
}

TEST(ContactContinuity, WithoutFrictionAClosedPathTakesNoWork)
{
    // The trapezoidal rule leaves little. Inside ridges of warped faces the blend leaves out how
    // their normals turn; three faces around a corner are the most warped.
    for (const Shape& shape : shapes)
        for (const int count : {3, 4, 5, 6}) {
            const std::string name = shape.name;
            const bool blended =
                name == "ridge" || name == "saddle" || name == "bump" || name == "jagged";
            EXPECT_LT(workAround(shape, count, 4000), !blended     ? 1e-5
                                                      : count == 3 ? 0.04
                                                                   : 0.005)
                << name << " of " << count << " faces";
        }
}

} // namespace
} // namespace fpm
