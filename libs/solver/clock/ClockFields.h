#pragma once

#include "fields/Field.h"
#include "kernels/particle/StepClock.h"

namespace fpm {

/// Time and step of the run.
struct ClockFields : FieldSet {
    ClockFields(const Memory& memory, const NumberTypes& numbers)
        : FieldSet("clock", memory, numbers)
    {
        clock.assign({StepClock{}});
    }

    Field<StepClock> clock{*this, {"clock", Location::global, Role::state}};
};

} // namespace fpm
