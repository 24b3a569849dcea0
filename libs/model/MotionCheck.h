#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// Checks what the boundary conditions of `model` prescribe, node by node and component by
/// component. Throws InputError where two conditions contradict each other, where a node of a rigid
/// part is left free, and where a rigid part would change its shape. Logs where an initial velocity
/// or a force meets a component that is held or driven anyway. `dictionary` lends its places.
void checkMotions(const Model& model, const Dictionary& dictionary, Log& log);

} // namespace fpm
