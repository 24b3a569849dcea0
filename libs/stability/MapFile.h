#pragma once

#include "io/OutputFolder.h"
#include "stability/StabilityMap.h"

#include <filesystem>

namespace fpm {

/// The map as a table, one row a point: numbers in columns, `#` lines with what they mean. `key`
/// says what the points belong to (see mapKey).
void writeMap(const OutputFolder& output,
              const std::string& file,
              const StabilityMap& map,
              const std::string& key);

/// Takes over the finished points and rows of a file with the same key; others are left.
void readMap(const std::filesystem::path& file, StabilityMap& map, const std::string& key);

/// Changes whenever a point could come out otherwise: settings of the map, `caseText` of its case.
std::string mapKey(const MapSpec& map, std::string_view caseText);

} // namespace fpm
