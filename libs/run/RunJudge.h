#pragma once

#include "base/Archive.h"
#include "base/Log.h"
#include "model/Model.h"
#include "solver/Solver.h"

#include <optional>
#include <string>

namespace fpm {

/// Why a run cannot go on.
struct RunFailure {
    std::string what, advice;
};

/// Judges the balance of energy and, of a slow process, its inertia while a run goes on.
class RunJudge
{
public:
    explicit RunJudge(const Control& control) : control_(control) {}
    /// At a row or frame: warns, once each; a failure where the balance is lost.
    std::optional<RunFailure> judge(const Energies& energies, const StepClock& clock, Log& log);
    /// The same at any other moment, without a trace.
    std::optional<RunFailure> lost(const Energies& energies, const StepClock& clock) const;
    /// Line at the end; empty where no inertia is watched.
    std::string inertia() const;
    void keep(Archive& archive);

private:
    void judgeInertia(const Energies& energies, const StepClock& clock, Log& log);

    const Control& control_;
    double largestShare_ = 0;
    bool balanceWarned_ = false;
};

} // namespace fpm
