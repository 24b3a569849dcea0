#include "fields/Value.h"

#include "parallel/HostSpace.h"

namespace fpm {

const Memory& hostMemory()
{
    static const MemoryOf<HostSpace> memory;
    return memory;
}

} // namespace fpm
