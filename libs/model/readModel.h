#pragma once

#include "case/Case.h"
#include "model/Model.h"

namespace fpm {

/// Reads constant/mesh.vtkhdf and every dictionary of the case, checks them against one another and
/// against physics (units, wave speed). Throws InputError or Error(mesh). Contact surfaces must be
/// current (see ContactSetup.h). `control`: the run's control dictionary where it is another than
/// system/controlDict.
Model readModel(const Case& theCase, const Dictionary& control, Log& log);
Model readModel(const Case& theCase, Log& log);

} // namespace fpm
