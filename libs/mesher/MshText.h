#pragma once

#include <string>
#include <string_view>

namespace fpm {

/// Refuses (Error mesh) what is not a complete Gmsh mesh file of format 2.2 or 4.1. gmsh itself
/// runs any other text as a .geo script, and reads a file cut short, or with wrong counts, without
/// a word.
void checkMshText(const std::string& name, std::string_view text);

} // namespace fpm
