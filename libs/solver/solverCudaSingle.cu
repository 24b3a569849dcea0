#include "solver/cudaInstance.h"

namespace fpm {

std::unique_ptr<Solver> makeCudaSingle(const Model& model, bool audit)
{
    return makeCuda<SinglePrecision>(model, audit);
}

} // namespace fpm
