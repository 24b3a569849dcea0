#pragma once

#include "base/Error.h"

#include <cstdio>
#include <cstdlib>

namespace fpm::fuzz {

/// A refusal with a reason is a good answer; every other exception is none.
template <class Read>
void tried(Read read)
{
    try {
        read();
    } catch (const Error&) { // refused with a reason
    }
}

/// Ends the program where a reader returned what it promises not to.
inline void require(bool holds, const char* promise)
{
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", promise);
    std::abort();
}

} // namespace fpm::fuzz
