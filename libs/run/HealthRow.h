#pragma once

#include "base/Archive.h"

#include <string>
#include <vector>

namespace fpm {

/// One figure by which a run judges itself.
struct HealthRow {
    std::string figure;   ///< "hourglass / internal energy, part plate"
    double value = 0;     ///< the worst of the run
    double limit = 0;     ///< of `value`; 0: reported, not judged
    std::string where;    ///< may be empty
    double when = -1;     ///< time of the worst value; < 0: of the run as a whole
    bool finding = false; ///< the verdict is bad
    std::string advice;   ///< one line for a finding
};
using HealthRows = std::vector<HealthRow>;

/// The largest value of a run and its time.
struct Peak {
    double value = 0, time = 0;
    void take(double candidate, double at)
    {
        if (!(candidate > value)) return;
        value = candidate;
        time = at;
    }
    void keep(Archive& archive)
    {
        archive(value);
        archive(time);
    }
};

} // namespace fpm
