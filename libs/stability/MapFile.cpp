#include "stability/MapFile.h"

#include "base/Format.h"
#include "io/Checksum.h"
#include "io/Table.h"

#include <cmath>
#include <fstream>

namespace fpm {

namespace {

constexpr int layoutVersion = 1; ///< of the file, and of how outcomes are judged

std::string listed(const MapAxis& axis)
{
    std::string text = axis.parameter;
    for (const double value : axis.values) text.append(" ").append(toText(value));
    return text;
}

std::string rowText(const std::vector<double>& values)
{
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += ' ';
        text += toText(values[i]);
    }
    text += '\n';
    return text;
}

/// Whether a row may be a point that was run: the file may be damaged, or by another hand.
bool isPoint(const std::vector<double>& row)
{
    const double outcome = row[3];
    return row[2] == 1 && outcome == std::floor(outcome) && outcome >= 0 && outcome < outcomeCount;
}

} // namespace

std::string mapKey(const MapSpec& map, std::string_view caseText)
{
    Checksum sum;
    sum.addNumber(layoutVersion);
    sum.add(map.scene + "\n" + listed(map.x) + "\n" + listed(map.y) + "\n");
    for (const Scene& scene : probeScenes())
        if (scene.name == map.scene)
            for (const std::string& name : scene.parameters)
                sum.add(name + toText(map.fixed.of(name, -1)));
    sum.add(rowText({double(map.limits.steps), map.limits.energy, map.limits.penetration,
                     map.limits.chatter, map.eigenvalue ? 1.0 : 0.0}));
    sum.add(caseText);
    return sum.text();
}

void writeMap(const OutputFolder& output,
              const std::string& file,
              const StabilityMap& map,
              const std::string& key)
{
    std::string text = "# key " + key + "\n# " + map.spec.scene + "; outcome:";
    for (int i = 0; i < outcomeCount; ++i) text += format(" {} {}", i, nameOf(Outcome(i)));
    text += "\n# bounds as multiples of that from elements alone; done 0: not run yet\n# "
            + map.spec.x.parameter + " " + map.spec.y.parameter
            + " done outcome energyError penetration steps predictedStable elementStep withContact "
              "quality eigenvalue\n";
    const std::size_t columns = map.spec.x.values.size();
    for (std::size_t k = 0; k < map.points.size(); ++k) {
        const MapPoint point = map.points[k].value_or(MapPoint{});
        const Bounds row = map.rows[k / columns].value_or(Bounds{});
        text += rowText({map.spec.x.values[k % columns], map.spec.y.values[k / columns],
                         map.points[k] ? 1.0 : 0.0, double(int(point.result.outcome)),
                         point.result.energyError, point.result.penetration, point.result.steps,
                         point.predictedStable ? 1.0 : 0.0, row.elementStep, row.withContact,
                         row.quality, row.eigenvalue});
    }
    output.write(file, text);
}

void readMap(const std::filesystem::path& file, StabilityMap& map, const std::string& key)
{
    std::ifstream stream(file);
    std::string first;
    if (!std::getline(stream, first) || first != "# key " + key) return;
    stream.close();
    const Table table = readTable(file);
    if (table.rows.size() != map.points.size() || table.columns.size() != 12) return;
    const std::size_t columns = map.spec.x.values.size();
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const std::vector<double>& row = table.rows[k];
        if (row[8] > 0) map.rows[k / columns] = Bounds{row[8], row[9], row[10], row[11]};
        if (!isPoint(row)) continue;
        MapPoint point;
        point.result = {Outcome(int(row[3])), row[4], row[5], row[6]};
        point.predictedStable = row[7] != 0;
        map.points[k] = point;
    }
}

} // namespace fpm
