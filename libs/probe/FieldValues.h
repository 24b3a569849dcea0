#pragma once

#include "io/VtkHdf.h"

#include <string>
#include <vector>

namespace fpm {

/// Which number of a result field is wanted: a component, or for an empty one the scalar itself or
/// the magnitude of a vector.
struct FieldChoice {
    std::string field;
    std::string component; ///< "" | x y z magnitude (3 columns) | XX YY ZZ XY YZ XZ (6 columns)

    std::string text() const; ///< "U z", "Mises"
};

/// One number per node or per element.
struct ScalarField {
    bool onNodes = true;
    std::vector<double> values;
};

/// A field of a frame and where it lives.
struct FoundField {
    const ResultField* field;
    bool onNodes;
};

/// Throws Error(dictionary) listing the fields there are.
FoundField findField(const Frame& frame, const std::string& name);
/// {""}, {x y z} or {XX YY ZZ XY YZ XZ}; numbers for other widths.
std::vector<std::string> componentNames(std::size_t columns);
/// Throws Error(dictionary) when field or component do not exist.
ScalarField scalarField(const Frame& frame, const FieldChoice& choice);
/// -1 where the component changes sign under reflection in the planes marked in `mirrored`, else 1.
double mirrorSign(const std::string& component, const std::array<bool, 3>& mirrored);

} // namespace fpm
