#include "solver/cudaInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeCudaDouble(const Model& model, bool audit)
{
    return makeCuda<DoublePrecision>(model, audit);
}

} // namespace fpm
