#pragma once

#include "base/Log.h"

#include <fcntl.h>

#include <filesystem>

namespace fpm::test {

/// A log into a new file, as programs have it in their case.
inline Log logInto(const std::filesystem::path& file)
{
    return Log(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
}

} // namespace fpm::test
