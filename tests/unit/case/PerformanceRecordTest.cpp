#include "case/PerformanceRecord.h"

#include "io/RunMark.h"
#include "unit/case/TemporaryCase.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fpm {
namespace {

TEST(PerformanceRecord, IsReadBackAsItWasWritten)
{
    PerformanceRecord record;
    record.runId = "one";
    record.backend = "openmp";
    record.description = "openmp, 2 threads, avx512, double";
    record.elements = 7740;
    record.steps = 8928;
    record.deviceBytes = std::int64_t(5) << 32;
    record.wallSeconds = 12.5;
    record.parts = 3;
    record.partSteps = 17;
    record.partSeconds = 0.25;
    record.contactShare = 0.25;
    record.lastStep = 1.0 / 3;
    record.contactLimitedBy = "contact pair rodLayer: node 3 at (1 2 3), omega 4";
    record.frictionWork = {{"rodLayer", 7}, {"all with all", 0}};
    record.checksum = "00ff";
    const TemporaryCase folder;
    folder.write(performanceFile, record.text());

    const auto read = readPerformance(folder.root());

    ASSERT_TRUE(read);
    EXPECT_EQ(read->text(), record.text());
    EXPECT_EQ(read->frictionWork, record.frictionWork);
    EXPECT_EQ(read->lastStep, record.lastStep);
    EXPECT_EQ(read->deviceBytes, record.deviceBytes);
    EXPECT_EQ(read->parts, 3);
    EXPECT_EQ(read->partSteps, 17);
    EXPECT_EQ(read->partSeconds, 0.25);
    EXPECT_FALSE(read->nsPerElementStep);
    EXPECT_TRUE(std::isinf(read->elementStep)) << "no element bounds the step";
    EXPECT_EQ(markOf(folder.root() / performanceFile)->runId, "one");
}

TEST(PerformanceRecord, IsNoneWhereTheFileIsMissingOrNotOurs)
{
    const TemporaryCase folder;
    EXPECT_FALSE(readPerformance(folder.root()));
    for (const char* text : {"{ \"steps\": 3 }", "steps -1;", "frictionWork ( { work 1; } );"}) {
        folder.write(performanceFile, text);
        EXPECT_FALSE(readPerformance(folder.root())) << text;
    }
}

} // namespace
} // namespace fpm
