#pragma once

#include <map>
#include <string>
#include <vector>

namespace fpm {

/// Advice for an unknown name: "did you mean 'layer1'? parts of the mesh: layer1, layer2".
std::string nameAdvice(const std::string& name,
                       const std::vector<std::string>& candidates,
                       const std::string& whatTheyAre);

/// True for names that may become file or folder names: [A-Za-z0-9_.+-]{1,64}, no leading dot.
bool isFileName(const std::string& name);

template <class Value>
std::vector<std::string> keysOf(const std::map<std::string, Value>& map)
{
    std::vector<std::string> keys;
    for (const auto& entry : map) keys.push_back(entry.first);
    return keys;
}

} // namespace fpm
