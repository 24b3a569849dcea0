#pragma once

#include "application/Application.h"

#include <string>
#include <utility>
#include <vector>

namespace fpm {

/// Option names (without dash) and values (empty for a switch) in the order given.
using OptionValues = std::vector<std::pair<std::string, std::string>>;

/// The options every application has, then its own.
std::vector<Option> allOptions(const ApplicationInfo& info);

/// Understands -case dir, --case dir, -case=dir. Throws Error(commandLine).
OptionValues parseCommandLine(const ApplicationInfo& info, int argc, char** argv);

std::string helpText(const ApplicationInfo& info);

} // namespace fpm
