#include "stability/CatalogueScenes.h"

namespace fpm {

std::vector<Failure> pressingFailures()
{
    return {};
}

} // namespace fpm
