#include "model/Names.h"

#include "dictionary/Suggestion.h"

#include <algorithm>

namespace fpm {

namespace {

bool isNameLetter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'
           || c == '.' || c == '+' || c == '-';
}

} // namespace

std::string nameAdvice(const std::string& name,
                       const std::vector<std::string>& candidates,
                       const std::string& whatTheyAre)
{
    const auto close = nearest(name, candidates);
    const std::string question = close ? "did you mean '" + *close + "'? " : "";
    return question + whatTheyAre + ": " + (candidates.empty() ? "none" : listed(candidates));
}

bool isFileName(const std::string& name)
{
    return !name.empty() && name.size() <= 64 && name.front() != '.'
           && std::all_of(name.begin(), name.end(), isNameLetter);
}

} // namespace fpm
