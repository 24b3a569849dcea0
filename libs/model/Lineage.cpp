#include "model/Lineage.h"

#include "dictionary/Suggestion.h"
#include "model/Names.h"

#include <algorithm>

namespace fpm {

Lineage lineageOf(const Dictionary& parts, const std::string& name)
{
    Lineage lineage;
    std::vector<std::string> names;
    for (std::string next = name;;) {
        lineage.push_back(parts.sub(next));
        names.push_back(next);
        const Dictionary& entry = lineage.back();
        if (!entry.has("like")) return lineage;
        next = entry.word("like");
        if (!parts.has(next))
            entry.fail("like", "no part '" + next + "' to be like",
                       nameAdvice(next, parts.keys(), "entries of parts"));
        if (std::find(names.begin(), names.end(), next) != names.end())
            entry.fail("like", "'like' goes round in a circle: " + listed(names) + ", " + next,
                       "give the entries in one of these parts");
    }
}

const Dictionary& holder(const Lineage& lineage, std::string_view key)
{
    for (const Dictionary& entry : lineage)
        if (entry.has(key)) return entry;
    return lineage.front();
}

double number(const Lineage& lineage, std::string_view key, const Range& range)
{
    return holder(lineage, key).number(key, range);
}

} // namespace fpm
