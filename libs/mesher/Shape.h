#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "mesh/Mesh.h"
#include "mesher/Section.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fpm {

/// A node in its final place, and the faces of the body it lies on (bit k: Shape::faces[k]).
struct PlacedNode {
    Point position;
    unsigned faces = 0;
};

/// A structured body of meshDict. gmsh meshes it at unit size (`section` extruded over z = 0 ...
/// 1); `place` moves each node to where the dictionary says, exactly: what gmsh rounds is lost
/// there.
struct Shape {
    std::string name;
    std::string subject; ///< for messages: "system/meshDict, in bodies.rod"
    Section section;
    int layers = 1;
    std::int64_t cellCount = 0;
    std::vector<std::string> faces; ///< automatic side sets are <name>.<face>
    bool hasEnds = false;           ///< also <name>.ends = bottom and top
    double roundVolume = 0;         ///< of the round body that the mesh stands for; 0: it has none
    std::function<PlacedNode(const Point&)> place;
    /// Directions of xi, eta, zeta at a place of the unit shape; right-handed after `place`.
    std::function<std::array<Point, 3>(const Point&)> axes;
};

/// `type box`: one shape. Every cell is cut into `refinement` in each direction, here and below.
/// Throws InputError, as do all of these.
Shape readBox(const std::string& name, const Dictionary& entry, int refinement);
/// `type layers`: `count` boxes on top of one another, <name>1 at the bottom.
std::vector<Shape> readLayers(const std::string& name, const Dictionary& entry, int refinement);
/// `type cylinder`: a solid cylinder, or half or a quarter of it.
Shape readCylinder(const std::string& name, const Dictionary& entry, int refinement);
/// `type hollowCylinder`: a tube, or half or a quarter of it.
Shape readHollowCylinder(const std::string& name, const Dictionary& entry, int refinement);

/// Meshes the shape: one part, its automatic side sets, hexahedra along `axes`.
Mesh meshShape(const Shape& shape, Log& log);

/// Largest count of cells along one direction of a body.
inline constexpr int maxCellsInRow = 100'000;
/// Three whole numbers 1 ... maxCellsInRow under `key`, before refinement.
std::array<int, 3> readCells(const Dictionary& entry, std::string_view key);
/// `cells` cut into `refinement` each; refuses, at `key`, more than `most`.
int refined(const Dictionary& entry, std::string_view key, int cells, int refinement, int most);
/// Refuses, at `key`, a body with more cells or nodes than an Index can count.
void requireCountable(const Dictionary& entry, std::string_view key, std::int64_t cells);

} // namespace fpm
