#include "advise/StaticAdvice.h"

#include "advise/ReducedCase.h"
#include "advise/Symmetry.h"
#include "base/Format.h"
#include "mesh/Surface.h"
#include "mesh/Vector.h"
#include "model/readModel.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

const char* const fraction[] = {"", "half", "quarter", "eighth"};

/// Largest speed at which a condition moves a point, for a displacement of 1 along its amplitude.
double steepest(const Amplitude& amplitude)
{
    double most = 0;
    for (std::size_t i = 1; i < amplitude.rows.size(); ++i) {
        const auto &a = amplitude.rows[i - 1], &b = amplitude.rows[i];
        most = std::max(most, std::abs(b[1] - a[1]) / (b[0] - a[0]));
    }
    // The middle of tau^3 (10 - 15 tau + 6 tau^2).
    return amplitude.kind == Amplitude::Kind::smooth ? 1.875 * most : most;
}

double largest(const Amplitude& amplitude)
{
    double most = 0;
    for (const auto& row : amplitude.rows) most = std::max(most, std::abs(row[1]));
    return most;
}

/// Largest speed prescribed; nothing where loads act.
std::optional<double> fastestDrive(const Model& model)
{
    using Kind = BoundaryCondition::Kind;
    double most = 0;
    for (const Point& v : initialVelocities(model)) most = std::max(most, vector::length(v));
    for (const BoundaryCondition& condition : model.boundaryConditions) {
        if (condition.isLoad()) return {};
        const double size = vector::length(condition.value);
        if (condition.kind == Kind::velocity)
            most = std::max(most, size * largest(condition.amplitude));
        else if (condition.kind == Kind::displacement)
            most = std::max(most, size * steepest(condition.amplitude));
        else if (condition.kind == Kind::rotation)
            return {};
    }
    for (const RigidSurface& surface : model.rigidSurfaces) {
        const double size = vector::length(surface.value);
        if (surface.motion == RigidSurface::Motion::velocity)
            most = std::max(most, size * largest(surface.amplitude));
        else if (surface.motion == RigidSurface::Motion::displacement)
            most = std::max(most, size * steepest(surface.amplitude));
    }
    return most;
}

struct Box {
    Point low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    void add(const Point& p)
    {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
};

/// Whether probeDict reads every frame, and the times its pictures read.
struct FramesRead {
    bool every = false, last = false;
    std::vector<double> times;
};

FramesRead framesRead(const Case& theCase)
{
    FramesRead read;
    if (!theCase.hasFile("system/probeDict")) return read;
    const Dictionary probes = theCase.dictionary("system/probeDict");
    const Dictionary tables = probes.subOrEmpty("tables"), pictures = probes.subOrEmpty("pictures");
    for (const std::string& name : tables.keys()) {
        const bool profile = tables.sub(name).wordOr("type", "") == "profile";
        (profile ? read.last : read.every) = true;
    }
    for (const std::string& name : pictures.keys()) {
        const Dictionary picture = pictures.sub(name);
        if (!picture.has("times"))
            read.last = true;
        else
            for (const double time : picture.numbers("times")) read.times.push_back(time);
    }
    std::sort(read.times.begin(), read.times.end());
    read.times.erase(std::unique(read.times.begin(), read.times.end()), read.times.end());
    return read;
}

/// The longest interval, whole times the one there is, that hits every time read.
double longestInterval(const Control& control, const std::vector<double>& times)
{
    const auto most = std::int64_t(std::llround(control.endTime / control.writeInterval));
    for (std::int64_t n = most; n > 1; --n) {
        const double interval = double(n) * control.writeInterval;
        const bool hits = std::all_of(times.begin(), times.end(), [&](double time) {
            const double share = time / interval;
            return std::abs(share - std::round(share)) * double(n) < 0.02
                   || std::abs(time - control.endTime) < 0.02 * control.writeInterval;
        });
        if (hits) return interval;
    }
    return control.writeInterval;
}

double frameBytes(const Model& model)
{
    const double perNode = model.contactPairs.empty() ? 6 : 9, perElement = 9;
    return 4
           * (perNode * double(model.mesh.points.size())
              + perElement * double(model.mesh.hexahedra.size()));
}

} // namespace

bool apart(const Mesh& mesh, const ContactPair& pair, const std::vector<double>& displacement)
{
    Box contactor, target;
    for (const Index node : pair.contactorNodes) contactor.add(mesh.points[std::size_t(node)]);
    for (const Index node : nodesOf(mesh, pair.targetSides))
        target.add(mesh.points[std::size_t(node)]);
    for (std::size_t c = 0; c < 3; ++c)
        if (contactor.low[c] - target.high[c] > 2 * displacement[c]
            || target.low[c] - contactor.high[c] > 2 * displacement[c])
            return true;
    return false;
}

std::optional<Advice> symmetryAdvice(const Model& model, Log& log)
{
    const SymmetryFinding finding = symmetryFinding(model);
    for (const std::string& obstacle : finding.obstacles) log.line("no mirror plane " + obstacle);
    if (finding.planes.empty()) return {};
    std::string planes;
    for (const MirrorPlane& plane : finding.planes)
        planes += (planes.empty() ? "" : ", ") + plane.text();
    const bool slides = std::any_of(model.contactPairs.begin(), model.contactPairs.end(),
                                    [](const ContactPair& pair) { return pair.friction > 0; });
    const std::size_t left = finding.elements / std::size_t(finding.factor());
    return Advice{
        "symmetry",
        format("mirror plane{} {}: the {} is enough", finding.planes.size() > 1 ? "s" : "", planes,
               fraction[finding.planes.size()]),
        "mesh, conditions, initial velocities, contact and rigid bodies are their own mirror image "
        "to 1e-9",
        format("{} % of the element-steps ({} of {} elements are left)",
               toText(100.0 * (1 - 1.0 / finding.factor()), 3), left, finding.elements),
        std::string("the two are not the same run: where the whole leaves its symmetry (buckling, "
                    "loose layers")
            + (slides ? ", friction that slips on one side first" : "")
            + "), they part; -measure shows by how much; resultants are those of the part that is "
              "kept",
        {},
        false};
}

std::vector<Advice> pairAdvice(const Model& model)
{
    std::vector<Advice> advice;
    const std::optional<double> fastest = fastestDrive(model);
    if (!fastest) return advice;
    const double displacement = 2 * *fastest * model.control.endTime;
    for (const ContactPair& pair : model.contactPairs) {
        if (pair.kind != ContactKind::pair || pair.surface >= 0) continue;
        if (!apart(model.mesh, pair, {displacement, displacement, displacement})) continue;
        Advice one{"pairs",
                   format("pair {} cannot meet", pair.name),
                   format("its boxes are farther apart than both move at {} until {}", 2 * *fastest,
                          model.control.endTime),
                   format("search and tracking of {} contactors", pair.contactorNodes.size()),
                   "none while no node is faster than twice the fastest prescribed",
                   {},
                   false};
        one.edits.remove("system/contactDict", "pairs." + pair.name,
                         format("{}: cannot meet", pair.name));
        advice.push_back(std::move(one));
    }
    return advice;
}

std::vector<Advice> outputAdvice(const Model& model, const Case& theCase)
{
    const Control& control = model.control;
    std::vector<Advice> advice;
    const FramesRead read = framesRead(theCase);
    const double frames = std::ceil(control.endTime / control.writeInterval) + 1;
    const double interval =
        read.every ? control.writeInterval : longestInterval(control, read.times);
    const double needed = std::ceil(control.endTime / interval * (1 - 1e-9)) + 1;
    if (needed < frames) {
        Advice one{"output",
                   format("writeInterval {} instead of {}", interval, control.writeInterval),
                   read.times.empty()
                       ? std::string("system/probeDict reads ")
                             + (read.last ? "the last frame" : "no frame")
                       : format("system/probeDict reads frames at {} times, no table reads all",
                                read.times.size()),
                   format("{} of {} frames, {} MB", toText(frames - needed, 6), toText(frames, 6),
                          toText((frames - needed) * frameBytes(model) / 1e6, 3)),
                   "fewer times to view in ParaView; steps end at frames, so results differ by "
                   "the error of the time integration",
                   {},
                   false};
        one.edits.set("system/controlDict", "writeInterval", toText(interval));
        advice.push_back(std::move(one));
    }
    const double rows = control.historyInterval > 0 ? control.endTime / control.historyInterval : 0;
    constexpr double manyRows = 20000;
    if (!control.histories.empty() && (rows == 0 || rows > manyRows)) {
        Advice one{
            "output",
            format("historyInterval {}", control.endTime / manyRows * 10),
            rows == 0 ? std::string("a row is written every step")
                      : format("{} rows a history", toText(rows, 6)),
            format("a stop of the step loop for every row beyond {}", toText(manyRows / 10, 5)),
            "peaks shorter than the interval are not recorded",
            {},
            false};
        one.edits.set("system/controlDict", "historyInterval",
                      toText(control.endTime / manyRows * 10));
        advice.push_back(std::move(one));
    }
    return advice;
}

} // namespace fpm
