#include "solver/cudaInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeCudaMixed(const Model& model, bool audit)
{
    return makeCuda<MixedPrecision>(model, audit);
}

} // namespace fpm
