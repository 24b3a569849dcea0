#pragma once

#include "base/Log.h"
#include "mesh/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fpm {

/// The table of fpmMesh: a line for each body as it is done, and one for all of them.
class MeshReport
{
public:
    /// Prints the head of the table.
    explicit MeshReport(Log& log);
    /// `roundVolume`: of the body with its arcs, where it is made of chords; 0: it has none.
    void add(const Mesh& body, double roundVolume = 0);
    void total(); ///< the last line, and what there is to say of single bodies

private:
    Log& log_;
    std::size_t bodies_ = 0, elements_ = 0, nodes_ = 0;
    double minScaledJacobian_, minHeight_, maxEdgeRatio_ = 0, volume_ = 0;
    std::vector<std::string> notes_; ///< below the table
};

/// One line for each side set with sides inside the material.
void reportInnerSides(const Mesh& mesh, Log& log);

/// One line where a few elements are so small that they set the time step of all.
void reportSmallElements(const Mesh& mesh, Log& log);

} // namespace fpm
