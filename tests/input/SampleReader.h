#pragma once

#include "dictionary/Dictionary.h"

namespace fpm {

/// Reads a dictionary made up to hold every kind of value once; not part of any application.
inline void readSample(const Dictionary& sample)
{
    sample.wordOr("title", "");
    sample.number("endTime", positive());
    sample.numberOr("safety", 0.9, between(0, 1));
    sample.numberOr("poissonsRatio", 0.3, {-1, 0.5, true, true});
    sample.numberOr("offset", 0);
    sample.integerOr("threads", 0, 0, 1024);
    sample.switchOr("selfContained", false);
    sample.choiceOr("backend", "openmp", {"serial", "openmp", "cuda"});
    sample.vectorOr("origin", {0, 0, 0});
    if (sample.has("times")) sample.numbers("times");
    if (sample.has("curve")) sample.rows("curve", 2);
    if (sample.has("sets")) sample.words("sets");
    if (sample.has("amplitude") && sample.leadingWord("amplitude") == "table")
        sample.tailRows("amplitude", 2);
    if (sample.has("within")) sample.tailNumbers("within");
    if (sample.has("blocks"))
        for (const auto& block : sample.subList("blocks")) block.number("length", positive());

    const auto pairs = sample.subOrEmpty("pairs");
    for (const auto& name : pairs.keys()) {
        const auto pair = pairs.sub(name);
        pair.word("contactor");
        pair.word("target");
        pair.numberOr("normalScale", 1, positive());
        pair.numberOr("friction", 0, nonNegative());
        pair.choiceOr("search", "faces", {"faces", "closestParticle"});
    }
    sample.requireAllUsed();
}

} // namespace fpm
