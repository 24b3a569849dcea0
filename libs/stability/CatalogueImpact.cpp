#include "stability/CatalogueScenes.h"

namespace fpm {

std::vector<Failure> impactFailures()
{
    return {};
}

} // namespace fpm
