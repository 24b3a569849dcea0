#pragma once

#include "model/ContactReader.h"
#include "model/Model.h"

#include <set>
#include <string>

namespace fpm {

/// Names for sets and conditions that a case does not use.
class FreeNames
{
public:
    /// `name`, or with the first number behind it that makes it free.
    std::string free(const std::string& name, const Model& model, const Mesh& mesh);

private:
    std::set<std::string> given_;
};

/// "(1 0 -2)", every component times `factor`, exactly.
std::string vectorText(const Point& vector, double factor);

/// A force on a node set: entry `name` with a share of what `condition` has.
std::string forceText(const BoundaryCondition& condition, const std::string& name, double share);

} // namespace fpm
