#include "stability/Catalogue.h"

#include "model/PaperAlgorithm.h"
#include "stability/CatalogueScenes.h"

#include <algorithm>

namespace fpm {

const char* nameOf(ContactVariant variant)
{
    static constexpr std::array<const char*, 3> names{"default", "paper", "remedy"};
    return names[std::size_t(variant)];
}

const char* nameOf(Fate fate)
{
    static constexpr std::array<const char*, 5> names{"holds", "loses", "warned", "refused", "-"};
    return names[std::size_t(fate)];
}

const std::vector<Failure>& catalogue()
{
    static const std::vector<Failure> all = [] {
        std::vector<Failure> list;
        for (const auto& part : {searchFailures(), slidingFailures(), impactFailures(),
                                 pressingFailures(), setUpFailures()})
            list.insert(list.end(), part.begin(), part.end());
        std::ranges::stable_sort(list, {}, &Failure::number);
        return list;
    }();
    return all;
}

Verdict judge(const Failure& failure, ContactVariant variant)
{
    if (failure.expected[std::size_t(variant)] == Fate::none) return {};
    Verdict out;
    out.measure = failure.run(variant);
    const Measure& got = out.measure;
    bool good = failure.atLeast ? got.value >= failure.limit : got.value <= failure.limit;
    if (!failure.words.empty()) good = got.said.find(failure.words) != std::string::npos;
    if (!good) // a value that is no number loses too
        out.fate = Fate::loses;
    else if (failure.words.empty())
        out.fate = Fate::holds;
    else
        out.fate = got.stopped ? Fate::refused : Fate::warned;
    return out;
}

bool isExpected(const Failure& failure, ContactVariant variant, Fate fate)
{
    return failure.expected[std::size_t(variant)] == fate;
}

Model asVariant(Model model, ContactVariant variant)
{
    if (variant == ContactVariant::paper) takePaperForms(model);
    return model;
}

} // namespace fpm
