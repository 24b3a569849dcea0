#include "advise/Results.h"

#include "advise/RigidFit.h"
#include "base/Format.h"
#include "case/PerformanceRecord.h"
#include "case/RunResults.h"
#include "io/VtkHdf.h"
#include "mesh/MeshFile.h"
#include "mesh/Quality.h"
#include "mesh/Vector.h"
#include "model/NodeSelection.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

/// Nothing where there is none of this name with so many columns.
const ResultField*
find(const std::vector<ResultField>& fields, const std::string& name, std::size_t columns)
{
    for (const ResultField& field : fields)
        if (field.name == name && field.columns == columns) return &field;
    return nullptr;
}

Point at(const ResultField& field, std::size_t i)
{
    return {field.values[3 * i], field.values[3 * i + 1], field.values[3 * i + 2]};
}

/// Elastic energy density of a stress.
double energyDensity(const double* s, const Part& part)
{
    const double trace = s[0] + s[1] + s[2],
                 square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2]
                          + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
    return 0.5 / part.youngsModulus
           * ((1 + part.poissonsRatio) * square - part.poissonsRatio * trace * trace);
}

/// Takes in one frame after the other.
class ResultReader
{
public:
    explicit ResultReader(const Model& model) : model_(model), fits_(model.parts.size())
    {
        results_.parts.resize(model.parts.size());
        results_.low = results_.high = model.mesh.points;
        for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e)
            volumes_.push_back(volume(model.mesh, Index(e)));
        for (std::size_t p = 0; p < model.parts.size(); ++p)
            nodes_.push_back(nodesOfPart(model.mesh, Index(p)));
    }

    void add(const Frame& frame, double time)
    {
        const ResultField *u = find(frame.nodeFields, "U", 3), *v = find(frame.nodeFields, "V", 3);
        if (results_.frames > 0)
            results_.longestStep = std::max(results_.longestStep, time - results_.lastTime);
        results_.lastTime = time;
        ++results_.frames;
        if (u) addPlaces(*u);
        if (v)
            for (std::size_t n = 0; n < model_.mesh.points.size(); ++n)
                results_.fastest = std::max(results_.fastest, vector::length(at(*v, n)));
        for (std::size_t part = 0; part < model_.parts.size(); ++part) {
            if (u) addDeviation(*u, part);
            addStress(frame, part);
        }
    }
    Results take() { return std::move(results_); }

private:
    void addPlaces(const ResultField& u)
    {
        for (std::size_t n = 0; n < model_.mesh.points.size(); ++n) {
            const Point place = vector::sum(model_.mesh.points[n], at(u, n));
            for (std::size_t c = 0; c < 3; ++c) {
                results_.low[n][c] = std::min(results_.low[n][c], place[c]);
                results_.high[n][c] = std::max(results_.high[n][c], place[c]);
            }
        }
    }

    void addDeviation(const ResultField& u, std::size_t part)
    {
        std::vector<Point> before, now;
        for (const Index node : nodes_[part]) {
            before.push_back(model_.mesh.points[std::size_t(node)]);
            now.push_back(vector::sum(before.back(), at(u, std::size_t(node))));
        }
        double& most = results_.parts[part].deviation;
        most = std::max(most, fits_[part].deviation(before, now));
    }

    void addStress(const Frame& frame, std::size_t part)
    {
        const ResultField *s = find(frame.elementFields, "S", 6),
                          *mises = find(frame.elementFields, "Mises", 1),
                          *strain = find(frame.elementFields, "PEEQ", 1);
        const MeshPart& run = model_.mesh.parts[part];
        PartExtremes& most = results_.parts[part];
        double energy = 0;
        for (Index i = run.firstElement; i < run.firstElement + run.elementCount; ++i) {
            const auto e = std::size_t(i);
            if (mises) most.mises = std::max(most.mises, mises->values[e]);
            if (strain) most.plasticStrain = std::max(most.plasticStrain, strain->values[e]);
            if (s && !isRigid(model_.parts[part].kind))
                energy += volumes_[e] * energyDensity(&s->values[6 * e], model_.parts[part]);
        }
        most.strainEnergy = std::max(most.strainEnergy, energy);
    }

    const Model& model_;
    std::vector<RigidFit> fits_;
    std::vector<double> volumes_;
    std::vector<std::vector<Index>> nodes_;
    Results results_;
};

StepFigures stepsOf(const PerformanceRecord& performance)
{
    return {double(performance.steps), performance.time, performance.elementStep,
            performance.contactLimitedBy};
}

std::optional<double> frictionWorkOf(const PerformanceRecord& performance, const std::string& pair)
{
    for (const auto& [name, work] : performance.frictionWork)
        if (name == pair) return work;
    return {};
}

/// Nothing where the run has none, or it is of another run.
std::optional<PerformanceRecord>
performanceOf(const std::filesystem::path& caseRoot, const std::string& runId, Log& log)
{
    auto performance = readPerformance(caseRoot);
    if (!performance || performance->runId.empty() || performance->runId == runId)
        return performance;
    log.warning(format("left out: {} is of another run", (caseRoot / performanceFile).string()));
    return {};
}

} // namespace

std::optional<Results>
readResults(const std::filesystem::path& caseRoot, const Model& model, Log& log)
{
    const RunResults found(caseRoot);
    found.report(log);
    ResultReader reader(model);
    const FrameMesh mesh = frameMesh(model.mesh);
    for (const auto& [folder, time] : found.frames())
        reader.add(readFrame(caseRoot / folder / "fields.vtkhdf", mesh), time);
    Results results = reader.take();
    if (results.frames < 2) return {};
    const auto performance = performanceOf(caseRoot, found.runId(), log);
    for (const ContactPair& pair : model.contactPairs)
        results.frictionWork.push_back(performance ? frictionWorkOf(*performance, pair.name)
                                                   : std::nullopt);
    if (performance && performance->steps > 0) results.steps = stepsOf(*performance);
    for (const History& history : model.control.histories) {
        const auto file = caseRoot / "postProcessing" / history.name / "0/energies.dat";
        if (history.kind != History::Kind::energies || !std::filesystem::exists(file)) continue;
        Table energies = readTable(file);
        if (otherRunOf(energies, found.runId()).empty())
            results.energies = std::move(energies);
        else
            log.warning(format("left out: {} is of another run", file.string()));
    }
    return results;
}

double largest(const Table& table, const std::string& column)
{
    double most = 0;
    for (const double value : table.values(column)) most = std::max(most, std::abs(value));
    return most;
}

double largestEnergy(const Table& energies)
{
    return std::max({largest(energies, "kinetic"), largest(energies, "internal"),
                     largest(energies, "external")});
}

} // namespace fpm
