#pragma once

#include "solver/backend/Backend.h"
#include "solver/contact/ContactLaunches.h"
#include "solver/contact/ListLaunches.h"
#include "solver/elements/ElementLaunches.h"
#include "solver/nodes/MotionLaunches.h"

#include <memory>

namespace fpm {

/// All kernels of one executor and precision. What is in them is compiled once for each; all else
/// is not.
struct Launches {
    std::unique_ptr<ElementLaunches> elements;
    std::unique_ptr<MotionLaunches> motion;
    std::unique_ptr<ContactLaunches> contact;
    std::unique_ptr<ListLaunches> lists;
};

} // namespace fpm
