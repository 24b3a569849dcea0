#include "stability/Stability.h"

#include "base/Format.h"
#include "model/Names.h"
#include "model/readModel.h"
#include "stability/MapChart.h"
#include "stability/MapFile.h"
#include "stability/MapReport.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

namespace fpm {

namespace {

std::string textOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// All that a case's points depend on.
std::string caseText(const Case& theCase)
{
    std::string text;
    for (const char* file :
         {"system/controlDict", "system/contactDict", "constant/partProperties",
          "constant/boundaryConditions", "0/initialConditions", "constant/mesh.vtkhdf"})
        if (theCase.hasFile(file)) text += textOf(theCase.path(file));
    return text;
}

Scene sceneOf(const MapSpec& spec, const Case& theCase, Log& log)
{
    for (const Scene& scene : probeScenes())
        if (scene.name == spec.scene) return scene;
    return caseScene(readModel(theCase, log));
}

class Progress
{
public:
    Progress(const StabilityMap& map, Log& log) : map_(map), log_(log), before_(map.done()) {}
    void tell()
    {
        const auto now = std::chrono::steady_clock::now();
        if (now - reported_ < std::chrono::milliseconds(500)) return;
        reported_ = now;
        const std::size_t done = map_.done();
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        std::string text = format("{}: {} of {} points", map_.spec.name, done, map_.points.size());
        if (done > before_)
            text += format(
                ", {} s left",
                toText(seconds * double(map_.points.size() - done) / double(done - before_), 2));
        log_.progress(text);
    }

private:
    const StabilityMap& map_;
    Log& log_;
    std::size_t before_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), reported_{};
};

/// What failed though it was predicted to be stable, point by point.
void reportSurprises(const StabilityMap& map, Log& log)
{
    const std::size_t columns = map.spec.x.values.size();
    for (std::size_t k = 0; k < map.points.size(); ++k) {
        const MapPoint& point = *map.points[k];
        if (!point.predictedStable || point.result.outcome == Outcome::stable) continue;
        log.warning(format("{}: {} {}, {} {}: {} though predicted to be stable (energy error {}, "
                           "penetration {})",
                           map.spec.name, map.spec.x.parameter, map.spec.x.values[k % columns],
                           map.spec.y.parameter, map.spec.y.values[k / columns],
                           nameOf(point.result.outcome), point.result.energyError,
                           point.result.penetration));
    }
}

void drawMap(const MapSpec& spec, const Case& theCase, int threads, Log& log)
{
    StabilityMap map{spec, {}, {}};
    map.points.resize(spec.x.values.size() * spec.y.values.size());
    map.rows.resize(spec.y.values.size());
    const bool ofCase = spec.scene == "case";
    const std::string key = mapKey(spec, ofCase ? caseText(theCase) : "");
    const OutputFolder output = theCase.output();
    const std::string stem = "postProcessing/stability/" + spec.name;
    readMap(theCase.path(stem + ".dat"), map, key);
    if (const std::size_t kept = map.done(); kept > 0)
        log.line(
            format("{}: {} of {} points are there already", spec.name, kept, map.points.size()));
    Progress progress(map, log);
    const Scene scene = sceneOf(spec, theCase, log);
    completeMap(map, scene, threads, [&] {
        writeMap(output, stem + ".dat", map, key);
        progress.tell();
    });
    map.own = ownPoint(spec, scene);
    log.finish();
    const std::string title =
        format("{}: {} over {}", spec.scene, spec.y.parameter, spec.x.parameter);
    output.write(stem + ".svg", mapChart(map, title));
    reportSurprises(map, log);
    log.line(format("{} ({}): {}", spec.name, title, conclusionOf(map)));
    if (const std::string own = ownSentence(map); !own.empty()) log.line("  " + own);
    log.line(format("  {}.dat, {}.svg", stem, spec.name));
}

} // namespace

void runStability(const Case& theCase,
                  const Dictionary& dictionary,
                  const std::string& only,
                  int threads,
                  Log& log)
{
    const std::vector<MapSpec> maps = readStabilityDict(dictionary);
    std::vector<std::string> names;
    for (const MapSpec& map : maps) names.push_back(map.name);
    if (!only.empty() && std::find(names.begin(), names.end(), only) == names.end())
        throw Error(ExitCode::commandLine, format("there is no map '{}'", only),
                    nameAdvice(only, names, "maps"));
    for (const MapSpec& map : maps)
        if (only.empty() || map.name == only) drawMap(map, theCase, threads, log);
}

} // namespace fpm
