#include "stability/CatalogueScenes.h"

namespace fpm {

std::vector<Failure> slidingFailures()
{
    return {};
}

} // namespace fpm
