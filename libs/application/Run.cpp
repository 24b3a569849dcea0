#include "application/Application.h"
#include "base/Format.h"
#include "case/Confinement.h"
#include "dictionary/Number.h"

#include <algorithm>

namespace fpm {

bool Run::has(std::string_view option) const
{
    return value(option).has_value();
}

std::optional<std::string> Run::value(std::string_view option) const
{
    const auto found = std::find_if(options_.begin(), options_.end(),
                                    [&](const auto& pair) { return pair.first == option; });
    return found == options_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> Run::choice(std::string_view option,
                                       const std::vector<std::string>& allowed) const
{
    const auto text = value(option);
    if (!text || std::find(allowed.begin(), allowed.end(), *text) != allowed.end()) return text;
    std::string list;
    for (const std::string& word : allowed) list += (list.empty() ? "" : ", ") + word;
    throw Error(ExitCode::commandLine,
                format("option -{} needs one of {}; found '{}'", option, list, *text));
}

std::optional<std::int64_t>
Run::integer(std::string_view option, std::int64_t lower, std::int64_t upper) const
{
    const auto text = value(option);
    if (!text) return std::nullopt;
    const auto number = readInteger(*text);
    if (!number || *number < lower || *number > upper)
        throw Error(ExitCode::commandLine,
                    format("option -{} needs an integer between {} and {}, found '{}'", option,
                           lower, upper, *text));
    return number;
}

Dictionary Run::dictionary() const
{
    const auto name = value("dict").value_or("");
    const auto file = theCase.path(name).lexically_normal();
    if (isBeneath(file, theCase.root())) return theCase.dictionary(name);
    // Named on the command line, so the user vouches for the folder it lies in.
    return Dictionary::read(file, file.parent_path());
}

} // namespace fpm
