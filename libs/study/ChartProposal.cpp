#include "study/ChartProposal.h"

#include "base/Format.h"
#include "study/CaseSurvey.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words)
{
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

/// Below one another, as the items of an entry of a ladder.
std::string stacked(const Words& words)
{
    std::string text;
    for (const std::string& word : words)
        text.append(text.empty() ? "" : "\n                         ").append(word);
    return text;
}

std::string listed(const Words& words)
{
    return format("({})", joined(words));
}

std::string short3(double value)
{
    return toText(value, 3);
}

std::string countsText(const std::vector<std::int64_t>& counts)
{
    Words words;
    for (const std::int64_t count : counts) words.push_back(std::to_string(count));
    return counts.size() == 1 ? words[0] : listed(words);
}

/// Whether every number of cells can be halved; one element stays one, as most through a layer do.
bool canBeHalved(const CaseSurvey& survey)
{
    bool some = false;
    for (const CaseSurvey::Cells& cells : survey.cells)
        for (const std::int64_t count : cells.counts) {
            if (count > 1 && count % 2 != 0) return false;
            some |= count > 3;
        }
    return some;
}

/// Names and steps of the rungs of a ladder of element sizes.
std::string namesAndSteps(const std::vector<double>& sizes)
{
    Words words;
    for (const double size : sizes) words.push_back(short3(size));
    return format("                names   {};\n                steps   {};\n", listed(words),
                  listed(words));
}

std::string refinedSizes(double size)
{
    return "                entry   meshDict.refinement;\n                values  (1 2 3);\n"
           + namesAndSteps({size, size / 2, size / 3});
}

std::string halvedSizes(const CaseSurvey& survey)
{
    Words entries{"meshDict.refinement"}, coarse{"1"}, own{"1"}, fine{"2"};
    for (const CaseSurvey::Cells& cells : survey.cells) {
        std::vector<std::int64_t> half = cells.counts;
        for (std::int64_t& count : half) count = std::max<std::int64_t>(1, count / 2);
        entries.push_back(cells.entry);
        coarse.push_back(countsText(half));
        for (Words* row : {&own, &fine}) row->push_back(countsText(cells.counts));
    }
    return format("                entries ({});\n                values  ({});\n",
                  stacked(entries), stacked({listed(coarse), listed(own), listed(fine)}))
           + namesAndSteps({2 * survey.size, survey.size, survey.size / 2});
}

/// A ladder of element sizes, coarse to fine; empty where a mesh file sets them.
std::string sizeLadder(const CaseSurvey& survey)
{
    if (survey.fromFile || survey.cells.empty()) return {};
    const bool halves = canBeHalved(survey);
    return format(
        "            // Longest edge of an element of the body that has the most. As it is: "
        "{}, {} elements\n            // in all. Run times are about as 1 to 16 to {}.\n"
        "            size\n            {\n{}            }\n",
        short3(survey.size), std::llround(survey.elements), halves ? 256 : 81,
        halves ? halvedSizes(survey) : refinedSizes(survey.size));
}

/// Forms of element: the same for all parts that deform, or yield where any does.
std::string formLadder(const CaseSurvey& survey)
{
    if (survey.parts.empty()) return {};
    Words keys{"hexahedron", "hourglass.form", "hourglass.coefficient"};
    if (survey.plastic) keys.push_back("hourglass.plastic");
    Words places, rows;
    for (const std::string& part : survey.parts)
        for (const std::string& key : keys)
            places.push_back("partProperties.parts." + part + "." + key);
    for (const char* form : {"reduced physical 1", "reduced viscous 0.1", "selective physical 1"})
        rows.push_back(listed(
            Words(survey.parts.size(), std::string(form) + (survey.plastic ? " coupled" : ""))));
    return format("            element\n            {\n                entries ({});\n"
                  "                values  ({});\n"
                  "                names   (physical viscous selective);\n            }\n",
                  stacked(places), stacked(rows));
}

std::string penaltyLadder(const CaseSurvey& survey)
{
    if (survey.pairs.empty()) return {};
    Words places, rows;
    for (const auto& [pair, scale] : survey.pairs)
        places.push_back("contactDict.pairs." + pair + ".normalScale");
    for (const double factor : {0.3, 3.0}) {
        Words row;
        for (const auto& [pair, scale] : survey.pairs) row.push_back(short3(factor * scale));
        rows.push_back(listed(row));
    }
    return format(
        "            contactLimit { entry controlDict.timeStep.contactLimit; values (0.25 1); "
        "}\n            // Of the normalScale there is.\n            penalty\n"
        "            {\n                entries ({});\n                values  ({});\n"
        "                names   (0.3 3);\n            }\n",
        stacked(places), stacked(rows));
}

std::string probesText(const CaseSurvey& survey, const std::string& finest)
{
    std::string text = "        probes\n        {\n";
    for (const CaseSurvey::Column& column : survey.columns)
        text += format("            {}\n            {\n                file        \"{}\";\n"
                       "                y           {};\n"
                       "                reference   { finest {}; }\n            }\n",
                       column.name, column.file, column.y, finest);
    return text + "        }\n";
}

std::string chartText(const std::string& name,
                      const std::string& comment,
                      const std::string& settings,
                      const std::string& ladders,
                      const std::string& probes)
{
    return format("    // {}\n    {}\n    {\n        cost        cpu;\n{}"
                  "        fixed       { serial { entry controlDict.backend; value serial; } }\n\n"
                  "        ladders\n        {\n{}        }\n\n{}    }\n",
                  comment, name, settings, ladders, probes);
}

} // namespace

std::string proposedChartDict(const Case& theCase)
{
    const CaseSurvey survey = surveyOf(theCase);
    if (survey.columns.empty())
        throw Error(ExitCode::dictionary, "this case has no history whose error could be charted",
                    "name one in 'functions' of system/controlDict, such as: tip { type point; "
                    "part <part>; position (0 0 0); }");
    std::string text =
        "/*--------------------------------*- C++ -*----------------------------------*\\\n"
        "  system/chartDict: speed against accuracy of this case, as fpmChart -writeDefaults\n"
        "  proposes it: cut what is not asked for, and name a reference where there is one. All\n"
        "  keywords: etc/caseDicts/chartDict, fpmChart -listKeys.\n"
        "\\*---------------------------------------------------------------------------*/\n"
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
        "    object      chartDict;\n}\n\ncharts\n{\n";
    const std::string sizes = sizeLadder(survey), forms = formLadder(survey);
    if (!sizes.empty())
        text += chartText("mesh", "Element sizes by form of element: the most of all errors.",
                          "        combine     product;\n        tolerance   0.02;\n",
                          sizes + forms, probesText(survey, "size"))
                + "\n";
    else
        text +=
            "    // The mesh comes from a file. Finer ones lie in folders of their own, with the "
            "files they\n    // replace: size { overlay (\"meshes/coarse\" none "
            "\"meshes/fine\"); names (2 1 0.5); steps (2 1 0.5); }\n";
    text +=
        chartText("knobs",
                  "One thing changed at a time: what moves the result less than the mesh errs "
                  "need not be paid for.",
                  "        tolerance   0.005;\n",
                  "            precision   { entry controlDict.precision; values (single mixed "
                  "double); }\n"
                  "            safety      { entry controlDict.timeStep.safety; values (0.6 0.9 "
                  "1); }\n"
                      + penaltyLadder(survey) + (sizes.empty() ? forms : ""),
                  probesText(survey, "precision"));
    return text + "}\n";
}

} // namespace fpm
