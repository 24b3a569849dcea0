#pragma once

#include <map>
#include <string>
#include <vector>

namespace fpm {

/// Values of the parameters that a map varies; the others keep the preset of the scene.
class Setting
{
public:
    double of(const std::string& parameter, double preset) const
    {
        const auto found = values_.find(parameter);
        return found == values_.end() ? preset : found->second;
    }
    bool has(const std::string& parameter) const { return values_.contains(parameter); }
    void set(const std::string& parameter, double value) { values_[parameter] = value; }

private:
    std::map<std::string, double> values_;
};

/// Names of parameters; what they mean: etc/caseDicts/stabilityDict.
namespace parameter {
inline const std::string timeStep = "timeStepFactor", ///< of the first bound from elements alone
    penalty = "normalScale",                          ///< of every pair
    speed = "speed",                                  ///< factor of the scene's own
    search = "searchInterval",                        ///< steps; 0: automatic
    mesh = "meshRatio",                               ///< face width of target over contactor
    density = "densityRatio", stiffness = "stiffnessRatio", ///< of contactor over target
    aspect = "aspectRatio",                                 ///< width over height of an element
    gap = "gap",                                            ///< before first contact [mm]
    hourglass = "hourglass";                                ///< coefficient of every part
} // namespace parameter

} // namespace fpm
