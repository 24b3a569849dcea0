#include "probe/Shell.h"

#include "mesh/Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fpm {

namespace {

const double creaseCosine = std::cos(35 * std::numbers::pi / 180);

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Area vector of a quad from its diagonals.
Point areaVector(const Quad& quad, const std::vector<Point>& at)
{
    const Point &a = at[std::size_t(quad[0])], &b = at[std::size_t(quad[1])];
    const Point &c = at[std::size_t(quad[2])], &d = at[std::size_t(quad[3])];
    const Point u{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point v{d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    return {(u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
            (u[0] * v[1] - u[1] * v[0]) / 2};
}

Point unitOrZero(const Point& a)
{
    const double length = std::sqrt(dot(a, a));
    if (!(length > 0)) return {0, 0, 0};
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// Bits of the mirror planes each mesh node lies in, to 1e-6 of the model's size.
std::vector<std::uint8_t> planeBits(const Mesh& mesh, const MirrorPlanes& mirror)
{
    std::vector<std::uint8_t> bits(mesh.points.size(), 0);
    for (std::size_t k = 0; k < 3; ++k) {
        if (!mirror.used[k] || mesh.points.empty()) continue;
        double lower = mesh.points[0][k], upper = lower;
        for (const Point& point : mesh.points)
            lower = std::min(lower, point[k]), upper = std::max(upper, point[k]);
        const double tolerance = 1e-6 * (upper - lower);
        for (std::size_t node = 0; node < bits.size(); ++node)
            if (std::abs(mesh.points[node][k] - mirror.origin[k]) <= tolerance)
                bits[node] |= std::uint8_t(1u << k);
    }
    return bits;
}

void connectQuads(Shell& shell)
{
    shell.aroundStart.assign(shell.nodes.size() + 1, 0);
    for (const Quad& quad : shell.quads)
        for (const Index vertex : quad) ++shell.aroundStart[std::size_t(vertex) + 1];
    for (std::size_t i = 1; i < shell.aroundStart.size(); ++i)
        shell.aroundStart[i] += shell.aroundStart[i - 1];
    shell.around.resize(4 * shell.quads.size());
    std::vector<Index> next(shell.aroundStart.begin(), shell.aroundStart.end() - 1);
    for (std::size_t quad = 0; quad < shell.quads.size(); ++quad)
        for (const Index vertex : shell.quads[quad])
            shell.around[std::size_t(next[std::size_t(vertex)]++)] = Index(quad);
}

std::span<const Index> quadsAround(const Shell& shell, Index vertex)
{
    const std::size_t begin = std::size_t(shell.aroundStart[std::size_t(vertex)]);
    const std::size_t end = std::size_t(shell.aroundStart[std::size_t(vertex) + 1]);
    return {shell.around.data() + begin, end - begin};
}

bool hasCorner(const Quad& quad, Index vertex)
{
    return std::find(quad.begin(), quad.end(), vertex) != quad.end();
}

/// Mean of the normals at a corner that differ little from the quad's own.
Point cornerNormal(const Shell& shell,
                   const std::vector<Point>& areas,
                   const std::vector<Point>& normals,
                   std::size_t quad,
                   Index vertex)
{
    Point sum{0, 0, 0};
    for (const Index other : quadsAround(shell, vertex)) {
        if (dot(normals[quad], normals[std::size_t(other)]) < creaseCosine) continue;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += areas[std::size_t(other)][k];
    }
    // beyond a mirror plane the surface goes on as its reflection
    for (std::size_t k = 0; k < 3; ++k)
        if (shell.planes[std::size_t(vertex)] >> k & 1 && std::abs(normals[quad][k]) < 0.5)
            sum[k] = 0;
    return unitOrZero(sum);
}

bool isCrease(const Shell& shell,
              const std::vector<Point>& normals,
              std::size_t quad,
              Index first,
              Index second)
{
    for (const Index other : quadsAround(shell, first))
        if (std::size_t(other) != quad && hasCorner(shell.quads[std::size_t(other)], second))
            return dot(normals[quad], normals[std::size_t(other)]) < creaseCosine;
    return (shell.planes[std::size_t(first)] & shell.planes[std::size_t(second)]) == 0;
}

} // namespace

Shell makeShell(const Mesh& mesh,
                std::span<const Index> parts,
                const MirrorPlanes& mirror,
                const std::vector<bool>& deleted)
{
    Shell shell;
    const std::vector<std::uint8_t> bits = planeBits(mesh, mirror);
    std::vector<Index> vertexOf(mesh.points.size(), -1);
    for (const Index part : parts) {
        const std::size_t firstVertex = shell.nodes.size();
        for (const ElementSide& side : skin(mesh, part, deleted)) {
            Quad quad = mesh.sideNodes(side);
            std::uint8_t common = 7;
            for (const Index node : quad) common &= bits[std::size_t(node)];
            if (common != 0) continue;
            for (Index& corner : quad) {
                Index& vertex = vertexOf[std::size_t(corner)];
                if (vertex < 0) {
                    vertex = Index(shell.nodes.size());
                    shell.nodes.push_back(corner);
                    shell.planes.push_back(bits[std::size_t(corner)]);
                }
                corner = vertex;
            }
            shell.quads.push_back(quad);
            shell.elements.push_back(side.element);
            shell.parts.push_back(part);
        }
        for (std::size_t vertex = firstVertex; vertex < shell.nodes.size(); ++vertex)
            vertexOf[std::size_t(shell.nodes[vertex])] = -1;
    }
    connectQuads(shell);
    return shell;
}

std::vector<double> vertexValues(const Shell& shell, const ScalarField& field)
{
    std::vector<double> values(shell.nodes.size());
    for (std::size_t vertex = 0; vertex < values.size(); ++vertex) {
        if (field.onNodes) {
            values[vertex] = field.values.at(std::size_t(shell.nodes[vertex]));
            continue;
        }
        double sum = 0, count = 0;
        for (const Index quad : quadsAround(shell, Index(vertex))) {
            const double value = field.values.at(std::size_t(shell.elements[std::size_t(quad)]));
            if (std::isfinite(value)) sum += value, count += 1;
        }
        values[vertex] = count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    }
    return values;
}

ShellShape makeShape(const Shell& shell, std::vector<Point> positions)
{
    ShellShape shape{std::move(positions), {}, {}};
    const std::size_t count = shell.quads.size();
    std::vector<Point> areas(count), normals(count);
    for (std::size_t quad = 0; quad < count; ++quad) {
        areas[quad] = areaVector(shell.quads[quad], shape.positions);
        normals[quad] = unitOrZero(areas[quad]);
    }
    shape.cornerNormals.resize(count);
    shape.creases.assign(count, 0);
    for (std::size_t quad = 0; quad < count; ++quad) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Index vertex = shell.quads[quad][k], next = shell.quads[quad][(k + 1) % 4];
            shape.cornerNormals[quad][k] = cornerNormal(shell, areas, normals, quad, vertex);
            if (isCrease(shell, normals, quad, vertex, next))
                shape.creases[quad] |= std::uint8_t(1u << k);
        }
    }
    return shape;
}

} // namespace fpm
