#include "stability/CatalogueScenes.h"

namespace fpm {

std::vector<Failure> setUpFailures()
{
    return {};
}

} // namespace fpm
