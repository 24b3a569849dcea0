#include "mesh/Quality.h"

#include "mesh/Surface.h"
#include "mesh/Vector.h"
#include "mesh/scaledJacobian.h"

#include <algorithm>
#include <limits>

namespace fpm {
namespace {

/// Corner numbers for which one formula gives dV/dx of each corner (Flanagan and Belytschko 1981).
constexpr std::array<std::array<std::size_t, 8>, 8> volumeCorners{{{0, 1, 2, 3, 4, 5, 6, 7},
                                                                   {1, 2, 3, 0, 5, 6, 7, 4},
                                                                   {2, 3, 0, 1, 6, 7, 4, 5},
                                                                   {3, 0, 1, 2, 7, 4, 5, 6},
                                                                   {4, 7, 6, 5, 0, 3, 2, 1},
                                                                   {5, 4, 7, 6, 1, 0, 3, 2},
                                                                   {6, 5, 4, 7, 2, 1, 0, 3},
                                                                   {7, 6, 5, 4, 3, 2, 1, 0}}};

constexpr std::array<std::array<std::size_t, 2>, 12> edges{{{0, 1},
                                                            {1, 2},
                                                            {2, 3},
                                                            {3, 0},
                                                            {4, 5},
                                                            {5, 6},
                                                            {6, 7},
                                                            {7, 4},
                                                            {0, 4},
                                                            {1, 5},
                                                            {2, 6},
                                                            {3, 7}}};

/// Longest edge by shortest edge.
double edgeRatio(const std::array<Point, 8>& x)
{
    double shortest = std::numeric_limits<double>::max(), longest = 0;
    for (const auto& [from, to] : edges) {
        const double length = vector::length(vector::difference(x[to], x[from]));
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    return shortest > 0 ? longest / shortest : std::numeric_limits<double>::infinity();
}

double largestSide(const Mesh& mesh, Index element)
{
    double largest = 0;
    for (Index side = 0; side < 6; ++side) largest = std::max(largest, area(mesh, {element, side}));
    return largest;
}

} // namespace

std::array<Point, 8> corners(const Mesh& mesh, Index element)
{
    std::array<Point, 8> x;
    for (std::size_t k = 0; k < 8; ++k)
        x[k] = mesh.points[std::size_t(mesh.hexahedra[std::size_t(element)][k])];
    return x;
}

double minScaledJacobian(const std::array<Point, 8>& x)
{
    constexpr std::array<std::array<std::size_t, 3>, 8> neighbours{
        {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
    double least = std::numeric_limits<double>::max();
    for (std::size_t corner = 0; corner < 8; ++corner) {
        std::array<Point, 3> edge;
        double product = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            edge[k] = vector::difference(x[neighbours[corner][k]], x[corner]);
            product *= vector::length(edge[k]);
        }
        const double jacobian = vector::dot(edge[0], vector::cross(edge[1], edge[2]));
        least = std::min(least, product > 0 ? jacobian / product : 0);
    }
    return least;
}

double volume(const Mesh& mesh, Index element)
{
    auto x = corners(mesh, element);
    const Point origin = x[0];
    // Relative coordinates: a body far from the origin keeps its digits.
    for (auto& point : x) point = vector::difference(point, origin);
    double sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const auto& n = volumeCorners[corner];
        const auto y = [&](std::size_t k) { return x[n[k - 1]][1]; };
        const auto z = [&](std::size_t k) { return x[n[k - 1]][2]; };
        sum += x[corner][0]
               * (y(2) * ((z(6) - z(3)) - (z(4) - z(5))) + y(3) * (z(2) - z(4))
                  + y(4) * ((z(3) - z(8)) - (z(5) - z(2))) + y(5) * ((z(8) - z(6)) - (z(2) - z(4)))
                  + y(6) * (z(5) - z(2)) + y(8) * (z(4) - z(5)));
    }
    return sum / 12;
}

Quality quality(const Mesh& mesh)
{
    constexpr double most = std::numeric_limits<double>::max();
    Quality result{most, 0, 0, most, 0, -1};
    std::vector<double> jacobians(mesh.hexahedra.size());
    for (Index element = 0; element < Index(mesh.hexahedra.size()); ++element) {
        const auto x = corners(mesh, element);
        const double jacobian = minScaledJacobian(x);
        jacobians[std::size_t(element)] = jacobian;
        if (jacobian < result.minScaledJacobian) {
            result.minScaledJacobian = jacobian;
            result.worstElement = element;
        }
        const double elementVolume = volume(mesh, element);
        result.maxEdgeRatio = std::max(result.maxEdgeRatio, edgeRatio(x));
        result.minHeight = std::min(result.minHeight, elementVolume / largestSide(mesh, element));
        result.totalVolume += elementVolume;
    }
    if (jacobians.empty()) return {0, 0, 0, 0, 0, -1};
    const auto middle = jacobians.begin() + std::ptrdiff_t(jacobians.size() / 2);
    std::nth_element(jacobians.begin(), middle, jacobians.end());
    result.medianScaledJacobian = *middle;
    return result;
}

} // namespace fpm
