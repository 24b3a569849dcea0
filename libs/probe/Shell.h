#pragma once

#include "mesh/Mesh.h"
#include "probe/FieldValues.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fpm {

/// Planes x = origin[0], y = origin[1], z = origin[2] a symmetric model is reflected in.
struct MirrorPlanes {
    std::array<bool, 3> used{false, false, false};
    Point origin{0, 0, 0};
};

/// The outer surface of parts as quadrilaterals over vertices of their own. A node shared by two
/// parts is two vertices, so that values are never averaged across an interface.
struct Shell {
    std::vector<Index> nodes;               ///< mesh node of each vertex
    std::vector<std::uint8_t> planes;       ///< bit k: the vertex lies in mirror plane k
    std::vector<Quad> quads;                ///< vertices, counter-clockwise seen from outside
    std::vector<Index> elements, parts;     ///< of each quad
    std::vector<Index> around, aroundStart; ///< quads around each vertex, CSR
};

/// Surface of the given parts; faces in the mirror planes are left out, they lie inside the whole.
/// `deleted`: of every element, or empty; the surface is that of the others.
Shell makeShell(const Mesh& mesh,
                std::span<const Index> parts,
                const MirrorPlanes& mirror,
                const std::vector<bool>& deleted = {});

/// Values at the vertices: nodal ones as they are, element values as the mean over the quads around
/// the vertex. NaN values do not take part in a mean.
std::vector<double> vertexValues(const Shell& shell, const ScalarField& field);

/// Geometry of the deformed shell that shading needs.
struct ShellShape {
    std::vector<Point> positions;                    ///< of the vertices
    std::vector<std::array<Point, 4>> cornerNormals; ///< unit, smooth across edges below 35 degrees
    std::vector<std::uint8_t> creases;               ///< bit k: edge corner k - k+1 is a sharp one
};
ShellShape makeShape(const Shell& shell, std::vector<Point> positions);

} // namespace fpm
