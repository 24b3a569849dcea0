#pragma once

#include "fields/Value.h"

#include <cstdint>

namespace fpm {

/// What the host books of a run, in its own memory.
struct LedgerFields : FieldSet {
    LedgerFields() : FieldSet("ledger", hostMemory(), {}) {}

    Value<double> startEnergy{*this, "startEnergy"};
    /// Largest so far of what Energies::scale names.
    Value<double> largestEnergy{*this, "largestEnergy"};
    /// Booked for contactors that are none any more.
    Value<double> lostSpring{*this, "lostSpring"};
    Value<double> lostFriction{*this, "lostFriction"};
    Value<double> lostDamping{*this, "lostDamping"};
    Value<double> lostWork{*this, "lostWork"};
    /// Step of the next search, where an interval is given.
    Value<std::int64_t> nextSearch{*this, "nextSearch"};
    /// Whole searches of passes that surfaces have left since.
    Value<std::int64_t> searches{*this, "searches"};
};

} // namespace fpm
