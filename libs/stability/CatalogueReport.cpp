#include "stability/CatalogueReport.h"

#include "base/Error.h"
#include "base/Format.h"
#include "io/Table.h"
#include "model/Names.h"
#include "probe/Svg.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <sstream>
#include <thread>

namespace fpm {

namespace {

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string numberOf(const Failure& failure)
{
    return format("F{}", failure.number);
}

/// Rounding errors are printed without digits.
std::string short_(double value)
{
    return std::abs(value) < 1e-9 && value != 0 ? std::string("< 1e-9") : toText(value, 2);
}

/// "0.04: loses", or the fate alone.
std::string textOf(const Failure& failure, const Verdict& verdict)
{
    if (verdict.fate == Fate::none) return "-";
    if (!failure.words.empty()) return nameOf(verdict.fate);
    return short_(verdict.measure.value) + ": " + nameOf(verdict.fate);
}

std::string limitOf(const Failure& failure)
{
    if (!failure.words.empty()) return "";
    return (failure.atLeast ? ">= " : "<= ") + toText(failure.limit, 2);
}

void printRow(const CatalogueRow& row, Log& log)
{
    const Failure& failure = *row.failure;
    std::string line =
        padded(numberOf(failure), 4) + padded(failure.name, 19) + padded(limitOf(failure), 11);
    for (const Verdict& verdict : row.verdicts) line += padded(textOf(failure, verdict), 17);
    log.line(line + (row.isExpected() ? "yes" : "NO"));
    if (row.isExpected()) return;
    for (const ContactVariant variant : allVariants) {
        const Verdict& verdict = row.verdicts[std::size_t(variant)];
        if (isExpected(failure, variant, verdict.fate)) continue;
        log.warning(format("{} {}: {} {}, expected: {} ({})", numberOf(failure), failure.name,
                           nameOf(variant), nameOf(verdict.fate),
                           nameOf(failure.expected[std::size_t(variant)]), failure.quantity));
        if (!verdict.measure.said.empty()) log.line("  it said: " + verdict.measure.said);
    }
}

/// Runs all rows in `threads` threads.
void runRows(std::vector<CatalogueRow>& rows, int threads)
{
    std::atomic<std::size_t> next{0};
    std::mutex guard;
    std::exception_ptr error;
    const auto serve = [&] {
        for (std::size_t i = next++; i < rows.size() * allVariants.size(); i = next++) try {
                CatalogueRow& row = rows[i / allVariants.size()];
                row.verdicts[i % allVariants.size()] =
                    judge(*row.failure, allVariants[i % allVariants.size()]);
            } catch (...) {
                const std::lock_guard lock(guard);
                error = std::current_exception();
            }
    };
    std::vector<std::thread> helpers;
    for (int t = 1; t < threads; ++t) helpers.emplace_back(serve);
    serve();
    for (std::thread& helper : helpers) helper.join();
    if (error) std::rethrow_exception(error);
}

constexpr std::array<const char*, 5> colours{"#cfe8d5", "#8f1d21", "#f6d776", "#8ecae6", "#f3f4f6"};

/// A matrix: one row per entry, one column per variant, coloured by outcome.
std::string matrixChart(const std::vector<CatalogueRow>& rows)
{
    constexpr double left = 190, top = 70, width = 150, height = 20;
    SvgDrawing svg(left + 3 * width + 20, top + height * double(rows.size()) + 20,
                   "Failure catalogue of node-to-face contact");
    svg.text({16, 28}, "Failure catalogue of node-to-face contact",
             {17, Anchor::start, "#111827", true});
    for (const ContactVariant variant : allVariants)
        svg.text({left + (double(variant) + 0.5) * width, top - 10}, nameOf(variant),
                 {13, Anchor::middle});
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = top + height * double(i);
        const Failure& failure = *rows[i].failure;
        svg.text({left - 8, y + 14}, numberOf(failure) + "  " + failure.name, {12, Anchor::end});
        for (const ContactVariant variant : allVariants) {
            const Verdict& verdict = rows[i].verdicts[std::size_t(variant)];
            const double x = left + double(variant) * width;
            svg.rectangle(
                {x, y}, width, height,
                format("fill=\"{}\" stroke=\"#ffffff\"", colours[std::size_t(verdict.fate)]));
            const bool dark = verdict.fate == Fate::loses;
            svg.text({x + width / 2, y + 14}, textOf(failure, verdict),
                     {12, Anchor::middle, dark ? "#ffffff" : "#111827"});
        }
    }
    return svg.str();
}

/// Columns of numbers only, so that any program reads them: entry counts from 0 in the order of
/// catalogue(), outcomes in the order of Fate.
Table tableOf(const std::vector<CatalogueRow>& rows)
{
    Table table;
    table.columns = {"number", "entry", "way", "value", "limit", "outcome", "expected"};
    for (const CatalogueRow& row : rows)
        for (const ContactVariant variant : allVariants) {
            const Verdict& verdict = row.verdicts[std::size_t(variant)];
            if (verdict.fate == Fate::none) continue;
            table.rows.push_back({double(row.failure->number),
                                  double(row.failure - catalogue().data()), double(variant),
                                  verdict.measure.value, row.failure->limit, double(verdict.fate),
                                  double(isExpected(*row.failure, variant, verdict.fate))});
        }
    return table;
}

} // namespace

bool CatalogueRow::isExpected() const
{
    return std::ranges::all_of(allVariants, [&](ContactVariant variant) {
        return fpm::isExpected(*failure, variant, verdicts[std::size_t(variant)].fate);
    });
}

std::vector<const Failure*> chosenFailures(const std::string& names)
{
    std::vector<const Failure*> chosen;
    if (names.empty())
        for (const Failure& failure : catalogue()) chosen.push_back(&failure);
    std::istringstream words(names);
    for (std::string word; std::getline(words, word, ',');) {
        const std::size_t before = chosen.size();
        std::vector<std::string> known;
        for (const Failure& failure : catalogue()) {
            known.push_back(failure.name);
            if (word == failure.name || word == numberOf(failure)) chosen.push_back(&failure);
        }
        if (chosen.size() == before)
            throw Error(ExitCode::commandLine, format("there is no scene '{}'", word),
                        nameAdvice(word, known, "scenes"));
    }
    return chosen;
}

std::string failureDocument(const std::vector<CatalogueRow>& rows)
{
    std::string text =
        "# Where node-to-face penalty contact fails\n\n"
        "Written by `fpmStability -catalogue -to doc`; `ctest -L stability` runs the "
        "same scenes. Each fails if it\ndoes not end as it is expected to, and that "
        "is also when one that loses begins to hold. \"Default\" is what a case\n"
        "does that says nothing; \"paper\" is `algorithm paper`. Limits come from "
        "theory, never from earlier results.\nUnits: mm, tonne, s. Points where the "
        "default loses stand in `limits.md` too.\n\n"
        "| | scene | what fails | measured, limit | default | paper | remedy |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const CatalogueRow& row : rows) {
        const Failure& f = *row.failure;
        const std::string measured = f.words.empty()
                                         ? f.quantity + ", " + limitOf(f) + " (" + f.reason + ")"
                                         : "said: \"" + f.words + "\"";
        std::string remedy = f.remedy;
        if (row.verdicts[2].fate != Fate::none) remedy += " (" + textOf(f, row.verdicts[2]) + ")";
        if (!f.note.empty()) remedy += "; " + f.note;
        text += format("| {} | `{}` | {} | {} | {} | {} | {} |\n", numberOf(f), f.name, f.fails,
                       measured, textOf(f, row.verdicts[0]), textOf(f, row.verdicts[1]), remedy);
    }
    return text;
}

void runCatalogue(const std::string& names, const std::string& folder, int threads, Log& log)
{
    std::vector<CatalogueRow> rows;
    for (const Failure* failure : chosenFailures(names)) rows.push_back({failure, {}});
    runRows(rows, threads);
    log.line(padded("", 4) + padded("scene", 19) + padded("limit", 11) + padded("default", 17)
             + padded("paper", 17) + padded("remedy", 17) + "expected");
    for (const CatalogueRow& row : rows) printRow(row, log);
    if (!folder.empty()) {
        const OutputFolder to = OutputFolder::make(folder);
        to.write("failures.md", failureDocument(rows));
        to.write("failures.svg", matrixChart(rows));
        writeTable(to, "failures.dat", tableOf(rows));
        log.line(format("{}/failures.md, failures.svg, failures.dat", folder));
    }
    const auto wrong =
        std::ranges::count_if(rows, [](const CatalogueRow& row) { return !row.isExpected(); });
    if (wrong > 0)
        throw Error(ExitCode::numericalStop,
                    format("{} of {} scenes do not end as the catalogue says", wrong, rows.size()),
                    "find out why; where the scene is right, correct its entry");
    log.line(format("{} scenes, all as expected", rows.size()));
}

} // namespace fpm
