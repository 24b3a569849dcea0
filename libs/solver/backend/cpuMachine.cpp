#include "base/Error.h"
#include "base/Format.h"
#include "kernels/contact/distribute/PassSums.h"
#include "kernels/contact/lists/ListCheck.h"
#include "kernels/particle/Relaxation.h"
#include "kernels/particle/StepClockUpdate.h"
#include "parallel/CpuExecutor.h"
#include "solver/backend/builtExecutors.h"
#include "solver/backend/machineOf.h"

#include <algorithm>

namespace fpm {

namespace {

template <class Numbers, int Bits>
Machine machine(const std::string& description, int threads)
{
    if constexpr (!isBuiltForCpu<Numbers, Bits>()) {
        throw Error(ExitCode::device,
                    format("this build has no kernels in {} precision for vectors of {} bits",
                           Numbers::name, Bits),
                    "configure it with other FPM_PRECISIONS and FPM_WIDTHS");
    } else {
        // Enough for the largest patch a mesh may have (2048 nodes).
        const std::size_t scratch =
            std::max({elementScratch<typename Numbers::Work>(2048), nodeScratch(), bodyScratch(),
                      relaxationScratch(), PassListCheck::scratch(), PassSums::scratch()});
        return machineOf<Numbers>(CpuExecutor<Bits>(threads, scratch), description + Numbers::name);
    }
}

template <int Bits>
Machine machineFor(Precision precision, const std::string& description, int threads)
{
    switch (precision) {
    case Precision::single:
        return machine<SinglePrecision, Bits>(description, threads);
    case Precision::mixed:
        return machine<MixedPrecision, Bits>(description, threads);
    case Precision::double_:
        break;
    }
    return machine<DoublePrecision, Bits>(description, threads);
}

} // namespace

Machine makeCpuMachine(const Control& control, const std::string& simd, int threads)
{
    const std::string description =
        control.backend + (followsIdleCores(control) ? ", up to " : ", ") + std::to_string(threads)
        + (threads == 1 ? " thread, " : " threads, ") + simd + ", ";
    if (simd == "avx512") return machineFor<512>(control.precision, description, threads);
    if (simd == "avx2") return machineFor<256>(control.precision, description, threads);
    return machineFor<64>(control.precision, description, threads);
}

} // namespace fpm
