#include "base/Error.h"
#include "base/Format.h"
#include "model/ImposedMotion.h"
#include "model/NodeSelection.h"
#include "solver/SetUp.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// Volume, first and second moments of a part, in coordinates from `origin`.
struct Moments {
    double volume = 0;
    Point first{0, 0, 0};
    std::array<double, 6> second{}; ///< xx yy zz xy yz zx
};

/// One element by 3 x 3 x 3 Gauss points: exact, since the products are of degree 4 in each
/// natural coordinate.
void addElement(Moments& sum, const Mesh& mesh, Index element, const Point& origin)
{
    constexpr double corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    const double place[3] = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
    const double weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    for (int point = 0; point < 27; ++point) {
        const int i[3] = {point % 3, point / 3 % 3, point / 9};
        Point x{0, 0, 0};
        double t[3][3] = {};
        for (std::size_t k = 0; k < 8; ++k) {
            const Index node = mesh.hexahedra[std::size_t(element)][k];
            double f[3];
            for (int a = 0; a < 3; ++a) f[a] = 1 + corner[k][a] * place[i[a]];
            for (std::size_t c = 0; c < 3; ++c) {
                const double own = (mesh.points[std::size_t(node)][c] - origin[c]) / 8;
                x[c] += own * f[0] * f[1] * f[2];
                t[0][c] += own * corner[k][0] * f[1] * f[2];
                t[1][c] += own * corner[k][1] * f[2] * f[0];
                t[2][c] += own * corner[k][2] * f[0] * f[1];
            }
        }
        const double jacobian = t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1])
                                + t[0][1] * (t[1][2] * t[2][0] - t[1][0] * t[2][2])
                                + t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]);
        const double dv = weight[i[0]] * weight[i[1]] * weight[i[2]] * jacobian;
        sum.volume += dv;
        for (std::size_t c = 0; c < 3; ++c) {
            sum.first[c] += dv * x[c];
            sum.second[c] += dv * x[c] * x[c];
            sum.second[3 + c] += dv * x[c] * x[(c + 1) % 3];
        }
    }
}

Vec3<double> vec(const Point& a)
{
    return {a[0], a[1], a[2]};
}
Point point(const Vec3<double>& a)
{
    return {a.x, a.y, a.z};
}

Mat3<double> inverse(const Mat3<double>& m)
{
    const Vec3<double> a = cross(m.y, m.z), b = cross(m.z, m.x), c = cross(m.x, m.y);
    const double scale = 1 / dot(m.x, a);
    return transpose(Mat3<double>{scale * a, scale * b, scale * c});
}

/// Mass, centre and inertia from the mesh, replaced by what is given.
void setMass(RigidBody& body, const Part& part, const Mesh& mesh, Index number)
{
    const MeshPart& run = mesh.parts[std::size_t(number)];
    const Point origin = mesh.points[std::size_t(mesh.hexahedra[std::size_t(run.firstElement)][0])];
    Moments sum;
    for (Index e = run.firstElement; e < run.firstElement + run.elementCount; ++e)
        addElement(sum, mesh, e, origin);
    const GivenInertia& given = part.inertia;
    body.mass = given.mass > 0 ? given.mass : part.density * sum.volume;
    const double density = body.mass / sum.volume;
    Point mean{};
    for (std::size_t c = 0; c < 3; ++c) mean[c] = sum.first[c] / sum.volume;
    std::array<double, 6> j = given.inertia;
    if (!given.hasInertia) {
        std::array<double, 6> s{};
        for (std::size_t c = 0; c < 3; ++c) {
            s[c] = density * (sum.second[c] - sum.volume * mean[c] * mean[c]);
            s[3 + c] = density * (sum.second[3 + c] - sum.volume * mean[c] * mean[(c + 1) % 3]);
        }
        j = {s[1] + s[2], s[2] + s[0], s[0] + s[1], -s[3], -s[4], -s[5]};
    }
    body.inertia = {{j[0], j[3], j[5]}, {j[3], j[1], j[4]}, {j[5], j[4], j[2]}};
    body.inverseInertia = inverse(body.inertia);
    body.start = given.hasCentre
                     ? vec(given.centre)
                     : Vec3<double>{origin[0] + mean[0], origin[1] + mean[1], origin[2] + mean[2]};
    body.centre = body.start;
}

void setFreedom(RigidBody& body, const HeldBody& held)
{
    body.axes = {vec(held.axes[0]), vec(held.axes[1]), vec(held.axes[2])};
    for (int c = 0; c < 3; ++c) body.held |= int(held.translations[std::size_t(c)]) << c;
    body.turns = held.turns;
    body.axis = vec(held.axis);
    body.axisInertia = dot(body.axis, body.inertia * body.axis);
    body.q[3] = 1;
}

void setVelocity(RigidBody& body, const Model& model, Index part)
{
    Vec3<double> velocity{0, 0, 0}, turning{0, 0, 0}, spin{0, 0, 0};
    for (const InitialVelocity& initial : model.initialVelocities) {
        if (initial.part != part) continue;
        const Vec3<double> here = vec(initial.at(point(body.centre)));
        // As for nodes: a velocity is set, rotations add to it, in whatever order they stand.
        if (initial.rotates)
            turning += here;
        else
            velocity = here;
        spin += vec(initial.spin);
    }
    body.velocity = withoutHeldTranslation(body, velocity + turning);
    body.momentum = withoutHeldTurns(body, body.inertia * spin);
}

/// 1 / m and the largest eigenvalue of [r]x^T J^-1 [r]x: r itself is its third direction, with 0.
double bodyInverseMass(const RigidBody& body, const Vec3<double>& r)
{
    const double byMass = body.held == 7 ? 0 : 1 / body.mass;
    if (body.turns == 0) return byMass;
    const Vec3<double> columns[3] = {cross(r, Vec3<double>{1, 0, 0}),
                                     cross(r, Vec3<double>{0, 1, 0}),
                                     cross(r, Vec3<double>{0, 0, 1})};
    double trace = 0, squares = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double m = dot(columns[i], body.inverseInertia * columns[j]);
            if (i == j) trace += m;
            squares += m * m;
        }
    const double product = 0.5 * (trace * trace - squares);
    return byMass + 0.5 * trace + std::sqrt(std::max(0.0, 0.25 * trace * trace - product));
}

} // namespace

void addBodies(SolverSetUp& data, const Model& model, const std::vector<Index>& numbers)
{
    BodySetUp& out = data.bodies;
    for (Index part = 0; part < Index(model.parts.size()); ++part)
        if (model.parts[std::size_t(part)].kind == PartKind::rigidFree) out.part.push_back(part);
    if (out.part.empty()) return;
    out.bodyOf.assign(std::size_t(data.nodes.count), -1);
    out.useStart.push_back(0);
    for (const Index part : out.part) {
        RigidBody body{};
        setMass(body, model.parts[std::size_t(part)], model.mesh, part);
        setFreedom(body, heldBody(model, part));
        setVelocity(body, model, part);
        const Vec3<double> spin = spinOf(body, body.momentum);
        for (const Index node : nodesOfPart(model.mesh, part)) {
            const Vec3<double> arm = vec(model.mesh.points[std::size_t(node)]) - body.centre;
            out.bodyOf[std::size_t(node)] = Index(out.bodies.size());
            out.nodes.push_back(node);
            out.arm.push_back(point(arm));
            data.nodes.fixed[std::size_t(node)] = bodyNode | heldComponents;
            data.nodes.velocity[std::size_t(node)] = point(body.velocity + cross(spin, arm));
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const BoundaryCondition& condition = model.boundaryConditions[i];
            if (std::find(condition.parts.begin(), condition.parts.end(), part)
                != condition.parts.end())
                out.uses.push_back({numbers[i], -1, body.mass, 0});
        }
        out.useStart.push_back(Index(out.uses.size()));
        out.bodies.push_back(body);
    }
}

void addLoadedBodyNodes(SolverSetUp& data)
{
    BodySetUp& out = data.bodies;
    if (out.part.empty()) return;
    const auto has = [](const std::vector<Index>& start, std::size_t node) {
        return !start.empty() && start[node + 1] > start[node];
    };
    std::size_t entry = 0;
    for (Index number = 0; number < Index(out.bodies.size()); ++number) {
        out.blockStart.push_back(Index(out.blocks.size()));
        for (; entry < out.nodes.size(); ++entry) {
            const std::size_t node = std::size_t(out.nodes[entry]);
            if (out.bodyOf[node] != number) break;
            if (!has(data.nodes.conditionStart, node) && !has(data.nodes.pressureStart, node)
                && (data.contact.numberOf.empty() || data.contact.numberOf[node] < 0))
                continue;
            const bool opens = Index(out.blocks.size()) == out.blockStart.back()
                               || out.blocks.back().count == nodeBlock;
            if (opens) out.blocks.push_back({number, Index(out.loaded.size()), 0});
            ++out.blocks.back().count;
            out.loaded.push_back(Index(node));
            out.inverseMass.push_back(
                bodyInverseMass(out.bodies[std::size_t(number)], vec(out.arm[entry])));
        }
    }
    out.blockStart.push_back(Index(out.blocks.size()));
}

} // namespace fpm
