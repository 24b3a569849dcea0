#pragma once

#include "model/Model.h"
#include "stability/Setting.h"

#include <functional>
#include <string>
#include <vector>

namespace fpm {

/// A model to be driven to failure, and the criterion by which it is lost.
struct Trial {
    Model model;
    bool staysClosed = false;        ///< contact that opens again and again chatters
    std::vector<Index> upper, lower; ///< nodes of two surfaces that may not pass each other ...
    int axis = 2;                    ///< ... along this axis: upper stays above lower ...
    double passed = 0;               ///< ... but for so much [length]; 0: not watched
};

/// Something that fits in a few hundred elements.
struct Scene {
    std::string name;
    std::vector<std::string> parameters; ///< of the scene
    std::function<Trial(const Setting&)> make;
};

/// twoBars twoBlocks spinningBlock slidingCorner thinLayers compressedBillet; without `case`.
const std::vector<Scene>& probeScenes();
/// A case as it is read, its numbers changed: step, penalty, speed, search, hourglass.
Scene caseScene(Model model);

/// Sets the parameters that concern any model: speed of all initial velocities, penalty, search,
/// hourglass coefficient. The time step is the runner's.
void applyCommon(Model& model, const Setting& setting);

} // namespace fpm
