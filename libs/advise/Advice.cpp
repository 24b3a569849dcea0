#include "advise/Advice.h"

#include "base/Format.h"

namespace fpm {

const std::vector<std::string>& adviceKinds()
{
    static const std::vector<std::string> kinds{"rigid",    "elastic",   "hourglass", "pairs",
                                                "friction", "viscosity", "damping",   "step",
                                                "threads",  "output",    "precision", "symmetry"};
    return kinds;
}

void printAdvice(const std::vector<Advice>& advice, Log& log)
{
    if (advice.empty()) {
        log.line("no advice: nothing was found that this scene does not need");
        return;
    }
    int number = 0;
    for (const Advice& one : advice) {
        log.line(format("{}. {}: {}", ++number, one.kind, one.subject));
        log.line(format("     because  {}", one.reason));
        log.line(format("     saves    {}", one.saving));
        log.line(format("     price    {}", one.price));
        if (one.measureOnly) log.line("     judge    by -measure only");
    }
}

} // namespace fpm
