#include "case/PerformanceRecord.h"

#include "base/Error.h"
#include "dictionary/Dictionary.h"
#include "dictionary/DictionaryText.h"
#include "io/RunMark.h"

namespace fpm {

namespace {

std::optional<double> numberIn(const Dictionary& file, const char* key)
{
    return file.has(key) ? std::optional(file.number(key)) : std::nullopt;
}

std::int64_t countIn(const Dictionary& file, const char* key)
{
    return file.integerOr(key, 0, 0, std::numeric_limits<std::int64_t>::max());
}

PerformanceRecord parse(const Dictionary& file)
{
    PerformanceRecord record;
    record.runId = file.wordOr("runId", "");
    record.backend = file.wordOr("backend", "");
    record.precision = file.wordOr("precision", "");
    record.algorithm = file.wordOr("algorithm", "");
    record.description = file.wordOr("description", "");
    record.elements = countIn(file, "elements");
    record.nodes = countIn(file, "nodes");
    record.contactors = countIn(file, "contactors");
    record.steps = countIn(file, "steps");
    record.searches = countIn(file, "searches");
    record.deviceBytes = countIn(file, "deviceBytes");
    record.wallSeconds = file.numberOr("wallSeconds", 0);
    record.parts = file.integerOr("parts", 1, 0, std::numeric_limits<std::int64_t>::max());
    record.partSteps = countIn(file, "partSteps");
    record.partSeconds = file.numberOr("partSeconds", 0);
    record.threads = file.numberOr("threads", 0);
    record.nsPerElementStep = numberIn(file, "nsPerElementStep");
    record.nsPerContactorStep = numberIn(file, "nsPerContactorStep");
    record.contactShare = numberIn(file, "contactShare");
    record.bytesPerElementStep = numberIn(file, "bytesPerElementStep");
    record.time = file.numberOr("time", 0);
    record.lastStep = file.numberOr("lastStep", 0);
    record.elementStep = file.numberOr("elementStep", record.elementStep);
    record.contactLimitedBy = file.wordOr("contactLimitedBy", "");
    if (file.has("frictionWork"))
        for (const Dictionary& pair : file.subList("frictionWork"))
            if (const auto work = numberIn(pair, "work"))
                record.frictionWork.emplace_back(pair.word("pair"), *work);
    record.checksum = file.wordOr("checksum", "");
    return record;
}

} // namespace

std::string PerformanceRecord::text() const
{
    DictionaryText text(RunMark{runId, performanceFile}.text());
    text.string("runId", runId)
        .string("backend", backend)
        .string("precision", precision)
        .string("algorithm", algorithm)
        .string("description", description)
        .integer("elements", elements)
        .integer("nodes", nodes)
        .integer("contactors", contactors)
        .integer("steps", steps)
        .integer("searches", searches)
        .number("wallSeconds", wallSeconds, 6)
        .integer("parts", parts)
        .integer("partSteps", partSteps)
        .number("partSeconds", partSeconds, 6)
        .number("threads", threads, 4)
        .number("nsPerElementStep", nsPerElementStep, 5)
        .number("nsPerContactorStep", nsPerContactorStep, 5)
        .number("contactShare", contactShare, 4)
        .number("bytesPerElementStep", bytesPerElementStep, 4)
        .integer("deviceBytes", deviceBytes)
        .number("time", time)
        .number("lastStep", lastStep)
        .number("elementStep", elementStep)
        .string("contactLimitedBy", contactLimitedBy);
    text.openList("frictionWork");
    for (const auto& [pair, work] : frictionWork)
        text.openItem().string("pair", pair).number("work", work).closeItem();
    return text.closeList().string("checksum", checksum).text();
}

std::optional<PerformanceRecord> readPerformance(const std::filesystem::path& caseRoot)
{
    std::error_code failure;
    const auto file = caseRoot / performanceFile;
    if (!std::filesystem::is_regular_file(file, failure)) return std::nullopt;
    try {
        return parse(Dictionary::read(file, caseRoot));
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace fpm
