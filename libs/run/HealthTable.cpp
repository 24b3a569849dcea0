#include "run/HealthTable.h"

#include "base/Format.h"
#include "dictionary/DictionaryText.h"
#include "io/RunMark.h"

#include <algorithm>

namespace fpm {

namespace {

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string verdict(const HealthRow& row)
{
    return row.finding ? "FINDING" : "ok";
}

std::string line(const HealthRow& row, std::size_t width)
{
    std::string text =
        format("  {}  {} {} {} {}", padded(row.figure, width), padded(toText(row.value, 3), 9),
               padded(row.limit > 0 ? format("({})", toText(row.limit, 3)) : "", 8),
               padded(verdict(row), 7), row.where);
    if (row.when >= 0) text += format("{}time {}", row.where.empty() ? "" : ", ", row.when);
    while (text.back() == ' ') text.pop_back();
    return text;
}

} // namespace

std::size_t findings(const HealthRows& rows)
{
    return std::size_t(
        std::count_if(rows.begin(), rows.end(), [](const HealthRow& row) { return row.finding; }));
}

std::string healthVerdict(const HealthRows& rows)
{
    const std::size_t count = findings(rows);
    if (count == 0) return "finished, healthy";
    return format("finished, {} finding{}", count, count > 1 ? "s" : "");
}

std::vector<std::string> healthLines(const HealthRows& rows)
{
    std::size_t width = 0;
    for (const HealthRow& row : rows) width = std::max(width, row.figure.size());
    std::vector<std::string> lines{"health of the run:"};
    for (const HealthRow& row : rows) {
        lines.push_back(line(row, width));
        if (row.finding) lines.push_back(format("    = {}", row.advice));
    }
    return lines;
}

std::string healthStatus(const HealthRows& rows)
{
    std::string names;
    for (const HealthRow& row : rows) {
        if (!row.finding) continue;
        const std::string name =
            row.where.empty() ? row.figure : format("{}, {}", row.figure, row.where);
        names += format("{}\"{}\"", names.empty() ? "" : " ", name);
    }
    return format("findings {};\nhealth ({});\n", findings(rows), names);
}

void writeHealth(const OutputFolder& theCase, const std::string& runId, const HealthRows& rows)
{
    const std::string file = "postProcessing/health/0/health";
    DictionaryText text(RunMark{runId, file}.text());
    text.string("runId", runId).integer("findings", std::int64_t(findings(rows)));
    text.openList("figures");
    for (const HealthRow& row : rows) {
        text.openItem().string("figure", row.figure).number("value", row.value);
        if (row.limit > 0) text.number("limit", row.limit);
        if (row.when >= 0) text.number("time", row.when);
        text.string("verdict", row.finding ? "finding" : "ok");
        if (!row.where.empty()) text.string("where", row.where);
        if (row.finding) text.string("advice", row.advice);
        text.closeItem();
    }
    theCase.write(file, text.closeList().text());
}

} // namespace fpm
