#include "advise/Advise.h"

#include "advise/CostAdvice.h"
#include "advise/PilotAdvice.h"
#include "advise/ReducedCase.h"
#include "advise/StaticAdvice.h"
#include "advise/Trial.h"
#include "base/Format.h"
#include "dictionary/Number.h"
#include "model/readModel.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <thread>

namespace fpm {

namespace {

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    return words;
}

std::vector<std::string> chosenKinds(const AdviseOptions& options)
{
    std::vector<std::string> chosen = splitAtCommas(options.apply.value_or(""));
    const auto& kinds = adviceKinds();
    for (const std::string& word : chosen)
        if (std::find(kinds.begin(), kinds.end(), word) == kinds.end()) {
            std::string valid;
            for (const std::string& kind : kinds) valid += (valid.empty() ? "" : ", ") + kind;
            throw Error(ExitCode::commandLine, format("-apply has no kind '{}'", word),
                        "valid: " + valid);
        }
    if (options.apply.has_value() != options.to.has_value())
        throw Error(ExitCode::commandLine, "-apply and -to belong together",
                    "such as: -apply symmetry,elastic -to ../reduced");
    return chosen;
}

/// Advice of the requested kinds; a kind without any is an error.
std::vector<Advice> chosenAdvice(const std::vector<Advice>& advice,
                                 const std::vector<std::string>& kinds)
{
    std::vector<Advice> chosen;
    for (const std::string& kind : adviceKinds()) {
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
        std::size_t found = 0;
        for (const Advice& one : advice)
            if (one.kind == kind) {
                ++found;
                const bool taken = std::any_of(chosen.begin(), chosen.end(), [&](const Advice& a) {
                    return !one.part.empty() && a.part == one.part;
                });
                if (!taken) chosen.push_back(one);
            }
        if (found == 0)
            throw Error(
                ExitCode::commandLine, format("there is no advice of kind {} to apply", kind),
                "leave it out of -apply; what needs results needs -pilot or a finished run");
    }
    return chosen;
}

/// Of a pilot run, else those the case has.
std::optional<Results>
findResults(const Case& theCase, const Model& model, const AdviseOptions& options, Log& log)
{
    if (const auto& text = options.pilot) {
        const auto share = readNumber(*text);
        if (!share || !(*share > 0) || *share > 1)
            throw Error(ExitCode::commandLine, format("-pilot {} is no share of endTime", *text),
                        "such as: -pilot 0.3; more than 0, at most 1");
        return pilotRun(theCase, model, *share, log);
    }
    auto results = readResults(theCase.root(), model, log);
    if (!results)
        log.line("no results of this mesh: advice on rigid and elastic parts, friction and "
                 "damping needs -pilot or a finished run");
    return results;
}

} // namespace

void advise(const Case& theCase, const AdviseOptions& options, Log& log)
{
    const std::vector<std::string> kinds = chosenKinds(options);
    const Model model = readModel(theCase, log);
    std::vector<Advice> advice;
    if (auto symmetry = symmetryAdvice(model, log)) advice.push_back(std::move(*symmetry));
    const std::optional<Results> results = findResults(theCase, model, options, log);
    for (Advice& one : results ? pilotAdvice(model, theCase, *results) : pairAdvice(model))
        advice.push_back(std::move(one));
    const auto add = [&](std::optional<Advice> one) {
        if (one) advice.push_back(std::move(*one));
    };
    add(hourglassAdvice(model, results));
    if (results) add(contactStepAdvice(model, *results));
    add(elementsAdvice(model));
    add(threadsAdvice(model, int(std::max(1u, std::thread::hardware_concurrency()))));
    for (Advice& one : outputAdvice(model, theCase)) advice.push_back(std::move(one));
    log.line();
    printAdvice(advice, log);
    if (options.measure) {
        log.line();
        measureAdvice(theCase, model, advice, log);
    }
    if (kinds.empty()) return;
    const std::vector<Advice> chosen = chosenAdvice(advice, kinds);
    const bool cut = std::find(kinds.begin(), kinds.end(), "symmetry") != kinds.end();
    writeReducedCase(theCase, chosen, cut, *options.to, log);
}

} // namespace fpm
