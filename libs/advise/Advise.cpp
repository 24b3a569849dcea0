#include "advise/Advise.h"

#include "advise/ReducedCase.h"
#include "advise/StaticAdvice.h"
#include "base/Format.h"
#include "model/readModel.h"

#include <algorithm>
#include <sstream>

namespace fpm {

namespace {

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    return words;
}

std::vector<std::string> chosenKinds(const Run& run)
{
    std::vector<std::string> chosen = splitAtCommas(run.value("apply").value_or(""));
    const auto& kinds = adviceKinds();
    for (const std::string& word : chosen)
        if (std::find(kinds.begin(), kinds.end(), word) == kinds.end()) {
            std::string valid;
            for (const std::string& kind : kinds) valid += (valid.empty() ? "" : ", ") + kind;
            throw Error(ExitCode::commandLine, format("-apply knows no '{}'", word),
                        "valid: " + valid);
        }
    if (run.has("apply") != run.has("to"))
        throw Error(ExitCode::commandLine, "-apply and -to belong together",
                    "such as: -apply symmetry,elastic -to ../reduced");
    return chosen;
}

/// What of the advice is asked for; a kind nothing was found of is an error.
std::vector<Advice> chosenAdvice(const std::vector<Advice>& advice,
                                 const std::vector<std::string>& kinds)
{
    std::vector<Advice> chosen;
    for (const std::string& kind : adviceKinds()) {
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
        const std::size_t before = chosen.size();
        for (const Advice& one : advice)
            if (one.kind == kind) chosen.push_back(one);
        if (chosen.size() == before)
            throw Error(
                ExitCode::commandLine, format("there is no advice of kind {} to apply", kind),
                "leave it out of -apply; what needs results needs -pilot or a finished run");
    }
    return chosen;
}

} // namespace

std::vector<Option> adviseOptions()
{
    return {{"apply", "<kinds>", "Write a new case: symmetry, rigid, elastic, ...; commas between"},
            {"to", "<dir>", "The folder of the new case; must not exist"}};
}

void advise(Run& run)
{
    const std::vector<std::string> kinds = chosenKinds(run);
    const Model model = readModel(run.theCase, run.log);
    std::vector<Advice> advice;
    if (auto symmetry = symmetryAdvice(model, run.log)) advice.push_back(std::move(*symmetry));
    for (Advice& one : pairAdvice(model)) advice.push_back(std::move(one));
    for (Advice& one : outputAdvice(model, run.theCase)) advice.push_back(std::move(one));
    run.log.line();
    printAdvice(advice, run.log);
    if (kinds.empty()) return;
    const std::vector<Advice> chosen = chosenAdvice(advice, kinds);
    const bool cut = std::find(kinds.begin(), kinds.end(), "symmetry") != kinds.end();
    writeReducedCase(run.theCase, chosen, cut, *run.value("to"), run.log);
}

} // namespace fpm
