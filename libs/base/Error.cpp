#include "base/Error.h"

namespace fpm {

Error::Error(ExitCode code, const std::string& message, const std::string& advice)
    : std::runtime_error(message),
      code_(code),
      advice_(advice)
{
}

} // namespace fpm
