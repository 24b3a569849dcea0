#include "probe/Probe.h"

#include "base/Error.h"
#include "base/Format.h"
#include "case/RunResults.h"
#include "io/RunMark.h"
#include "io/VtkHdf.h"
#include "mesh/MeshFile.h"
#include "probe/Png.h"
#include "probe/ProbeDict.h"
#include "probe/Svg.h"

#include <optional>
#include <span>

namespace fpm {

namespace {

/// Runs `work`; an error gets the entry of probeDict that it belongs to.
template <class Work>
auto named(const std::string& entry, const Work& work)
{
    try {
        return work();
    } catch (const Error& error) {
        throw Error(error.code(), entry + ": " + error.what(), error.advice());
    }
}

/// One run over a case: what was asked for, what lies in the time folders, what was made.
class ProbeRun
{
public:
    ProbeRun(const Case& theCase, const ProbeDict& probes, const TimeSelection& times, Log& log)
        : case_(theCase),
          probes_(probes),
          selected_(times),
          log_(log),
          results_(theCase.root()),
          all_(results_.frames())
    {
        results_.report(log);
    }

    void makeTables();
    void makePictures();
    void makePlots();
    std::vector<std::filesystem::path> made;

private:
    const Mesh& mesh();
    const FrameMesh& framesMesh();
    std::optional<Frame> load(const FrameTime& time);
    std::vector<FrameTime> framesFor(const TimeSelection& selection, const std::string& what);
    void makePicture(const PictureSpec& spec);
    std::string missingFiles(const PlotSpec& spec) const;
    void makePlot(const PlotSpec& spec);
    bool isOfThisRun(const Table& table, const PlotSpec& spec, const SeriesSpec& series);
    std::string mark(const std::string& relative) const;
    void write(const std::string& relative, std::string svg);
    void write(const std::string& relative, std::vector<std::uint8_t> png);
    void report(const std::string& relative);

    const Case& case_;
    const ProbeDict& probes_;
    const TimeSelection& selected_;
    Log& log_;
    RunResults results_;
    const std::vector<FrameTime>& all_;
    std::optional<Mesh> mesh_;
    std::optional<FrameMesh> framesMesh_;
};

const Mesh& ProbeRun::mesh()
{
    if (!mesh_) mesh_ = readMesh(case_.path(meshFile));
    return *mesh_;
}

const FrameMesh& ProbeRun::framesMesh()
{
    if (!framesMesh_) framesMesh_ = frameMesh(mesh());
    return *framesMesh_;
}

/// A frame the solver removed since the list was made (purgeWrite) is passed over with a line.
std::optional<Frame> ProbeRun::load(const FrameTime& time)
{
    const std::string relative = time.first + "/fields.vtkhdf";
    const FrameMesh& mesh = framesMesh();
    try {
        return readFrame(case_.path(relative), mesh);
    } catch (const Error&) {
        if (case_.hasFile(relative)) throw;
    }
    log_.line("time " + time.first + " is gone: skipped");
    return std::nullopt;
}

std::vector<FrameTime> ProbeRun::framesFor(const TimeSelection& selection, const std::string& what)
{
    const ChosenFrames chosen = chooseFrames(all_, selection);
    for (const double time : chosen.missing)
        log_.line(what + ": no results at time " + toText(time) + " (yet): skipped");
    return chosen.frames;
}

void ProbeRun::report(const std::string& relative)
{
    made.push_back(case_.path(relative));
    log_.line("wrote " + relative);
}

/// What a file says of itself; empty where the results name no run.
std::string ProbeRun::mark(const std::string& relative) const
{
    return results_.runId().empty() ? "" : RunMark{results_.runId(), relative}.text();
}

void ProbeRun::write(const std::string& relative, std::string svg)
{
    if (const std::string note = mark(relative); !note.empty())
        svg = withNote(std::move(svg), note);
    case_.output().write(relative, svg);
    report(relative);
}

void ProbeRun::write(const std::string& relative, std::vector<std::uint8_t> png)
{
    if (const std::string note = mark(relative); !note.empty()) addComment(png, note);
    case_.output().write(relative, std::as_bytes(std::span(png)));
    report(relative);
}

void ProbeRun::makeTables()
{
    if (probes_.tables.empty()) return;
    const auto times = selected_.empty() ? all_ : framesFor(selected_, "tables");
    if (times.empty()) {
        log_.line("tables: no results yet: skipped");
        return;
    }
    std::vector<TableProbe> tables;
    for (const TableSpec& spec : probes_.tables)
        named("table '" + spec.name + "'", [&] { tables.emplace_back(spec, mesh()); });
    for (const FrameTime& time : times)
        if (const auto frame = load(time))
            for (TableProbe& table : tables)
                named("table '" + table.spec().name + "'", [&] { table.sample(*frame); });
    for (const TableProbe& table : tables) {
        const TableSpec& spec = table.spec();
        const FrameTime& time =
            spec.kind == TableSpec::Kind::profile ? times.back() : times.front();
        const std::string relative =
            "postProcessing/" + spec.name + "/" + time.first + "/" + spec.field.field + ".dat";
        Table content = table.table();
        if (const std::string note = mark(relative); !note.empty()) content.notes = {note};
        writeTable(case_.output(), relative, content);
        report(relative);
    }
}

void ProbeRun::makePicture(const PictureSpec& spec)
{
    TimeSelection wanted = selected_;
    if (wanted.empty()) wanted.times = spec.times;
    if (wanted.empty()) wanted.latest = true;
    std::vector<FrameTime> times = framesFor(wanted, "picture '" + spec.name + "'");
    const bool meshOnly = spec.field.field == "Part" && all_.empty();
    if (times.empty() && !meshOnly) {
        log_.line("picture '" + spec.name + "': no results yet: skipped");
        return;
    }
    PicturePainter painter(spec, mesh());
    const auto draw = [&](const Frame& frame, const std::string& time) {
        const PictureFiles files = painter.draw(frame);
        const std::string stem = "postProcessing/pictures/" + spec.name + "_" + time;
        write(stem + ".svg", files.svg);
        write(stem + ".png", files.png);
    };
    if (meshOnly) {
        painter.include({});
        return draw({}, "0");
    }
    for (const FrameTime& time : times)
        if (const auto frame = load(time)) painter.include(*frame);
    for (const FrameTime& time : times)
        if (const auto frame = load(time)) draw(*frame, time.first);
}

void ProbeRun::makePictures()
{
    for (const PictureSpec& spec : probes_.pictures)
        named("picture '" + spec.name + "'", [&] { makePicture(spec); });
}

std::string ProbeRun::missingFiles(const PlotSpec& spec) const
{
    std::string text;
    for (const SeriesSpec& series : spec.series)
        if (!std::filesystem::is_regular_file(series.path))
            text += "\n  plot '" + spec.name + "', series '" + series.name + "': no file '"
                    + series.file + "'";
    return text;
}

/// Other runs may stand beside this one on purpose, from any other folder.
bool ProbeRun::isOfThisRun(const Table& table, const PlotSpec& spec, const SeriesSpec& series)
{
    if (!series.file.starts_with("postProcessing/")) return true;
    const std::string other = otherRunOf(table, results_.runId());
    if (!other.empty())
        log_.warning("plot '" + spec.name + "': '" + series.file + "' is of run " + other
                     + ", not of this one: left out");
    return other.empty();
}

void ProbeRun::makePlot(const PlotSpec& spec)
{
    Plot plot{spec.title, spec.x, spec.y, {}};
    for (const SeriesSpec& from : spec.series) {
        const Table table = readTable(from.path);
        if (!isOfThisRun(table, spec, from)) continue;
        PlotSeries series{from.label, table.values(from.xColumn), table.values(from.yColumn),
                          from.style};
        for (double& x : series.x) x = x * from.xScale + from.xOffset;
        for (double& y : series.y) y = y * from.yScale + from.yOffset;
        if (series.x.empty())
            log_.line("plot '" + spec.name + "': '" + from.file + "' has no rows yet");
        plot.series.push_back(std::move(series));
    }
    if (plot.series.empty()) return log_.line("plot '" + spec.name + "': no series: skipped");
    write("postProcessing/plots/" + spec.name + ".svg", svgPlot(plot));
}

void ProbeRun::makePlots()
{
    std::string missing;
    for (const PlotSpec& spec : probes_.plots) {
        const std::string files = missingFiles(spec);
        missing += files;
        if (files.empty()) named("plot '" + spec.name + "'", [&] { makePlot(spec); });
    }
    if (!missing.empty())
        throw Error(ExitCode::fileIo, "files that plots are made from do not exist:" + missing,
                    "run fpmExplicit first, or correct 'file' in system/probeDict");
}

} // namespace

std::vector<std::filesystem::path> runProbe(const Case& theCase,
                                            const Dictionary& dictionary,
                                            const ProbeSelection& selection,
                                            Log& log)
{
    const ProbeDict probes = readProbeDict(dictionary, theCase);
    ProbeRun run(theCase, probes, selection.times, log);
    if (selection.tables) run.makeTables();
    if (selection.pictures) run.makePictures();
    if (selection.plots) run.makePlots();
    return run.made;
}

} // namespace fpm
