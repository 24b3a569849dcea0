#include "stability/Catalogue.h"

#include <gtest/gtest.h>

#include <set>

namespace fpm {
namespace {

struct Run {
    const Failure* failure;
    ContactVariant variant;
};

std::vector<Run> allRuns()
{
    std::vector<Run> runs;
    for (const Failure& failure : catalogue())
        for (const ContactVariant variant : allVariants)
            if (failure.expected[std::size_t(variant)] != Fate::none)
                runs.push_back({&failure, variant});
    return runs;
}

class CatalogueScene : public testing::TestWithParam<Run>
{};

TEST_P(CatalogueScene, EndsAsItSays)
{
    const auto [failure, variant] = GetParam();
    const Verdict got = judge(*failure, variant);
    EXPECT_STREQ(nameOf(got.fate), nameOf(failure->expected[std::size_t(variant)]))
        << failure->quantity << ": " << got.measure.value << ", limit " << failure->limit
        << (got.measure.said.empty() ? "" : "\nsaid: ") << got.measure.said;
    RecordProperty("value", std::to_string(got.measure.value));
}

std::string testName(const testing::TestParamInfo<Run>& run)
{
    std::string name = "F";
    name += std::to_string(run.param.failure->number);
    name += "_" + run.param.failure->name + "_";
    return name + nameOf(run.param.variant);
}

INSTANTIATE_TEST_SUITE_P(F, CatalogueScene, testing::ValuesIn(allRuns()), testName);

} // namespace
} // namespace fpm
