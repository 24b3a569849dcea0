#include "run/ContactHealth.h"

#include "base/Format.h"
#include "run/HealthLimits.h"
#include "solver/Solver.h"

#include <algorithm>

namespace fpm {

namespace {

bool forgives(const ContactPair& pair)
{
    return pair.initialOverlap == InitialOverlap::offset
           || pair.initialOverlap == InitialOverlap::ramp;
}

/// What passes count of contactors that are not held as they ought to be.
struct Loss {
    std::int64_t PairForce::*count;
    const char *figure, *advice;
};
constexpr std::array<Loss, 4> losses{
    {{&PairForce::released, "contactors released",
      "they went deeper than the target is thick and hold no more: a larger normalScale, a "
      "thicker target, or general contact where another body is behind it"},
     {&PairForce::overEdge, "contactors that left over a free edge while inside",
      "what they held is lost there, and behind a gap they may meet the side of the next "
      "body and be thrown back: one surface without a gap, by joining the bodies in the mesh, or "
      "at least surfaces that are named without their sides"},
     {&PairForce::late, "lists of faces that were outrun",
      "contactors may have been missed: set searchInterval 1 or a smaller timeStep.maximum"},
     {&PairForce::crowded,
      "searches with more than three bodies in reach of a node, or eight edges of an edge",
      "it was held by the nearest: join bodies in the mesh, or stagger them so that no more "
      "than three meet; smaller elements along an edge that lies across many others"}}};

} // namespace

ContactHealth::ContactHealth(const Model& model, const Solver& solver)
    : model_(model),
      pairs_(model.contactPairs.size())
{
    for (const ContactPassSetup& pass : solver.contact().setUp().passes)
        pairs_[pass.pair].size = std::max(pairs_[pass.pair].size, pass.meanFaceSize);
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair)
        if (forgives(model.contactPairs[pair]))
            pairs_[pair].forgiven = solver.contact().initialOverlap(pair).deepest;
}

void ContactHealth::sample(const Sample& row)
{
    const double time = row.energies.time;
    const std::vector<PairStatus>& pairs = row.pairs;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        OfPair& of = pairs_[pair];
        const double before = of.depth.value;
        of.depth.take(pairs[pair].maxDepth - of.forgiven, time);
        if (of.depth.value > before) of.deepest = pairs[pair];
        const ContactPair& law = model_.contactPairs[pair];
        if (law.kind == ContactKind::pair && law.friction > 0)
            of.sliding.sample(time, pairs[pair], law);
        for (std::size_t loss = 0; loss < losses.size(); ++loss)
            if (of.since[loss] < 0 && row.forces[pair].*losses[loss].count > 0)
                of.since[loss] = time;
    }
}

void ContactHealth::keep(Archive& archive)
{
    for (OfPair& pair : pairs_) {
        archive(pair.size); // of the surface at the start, which may erode
        archive(pair.forgiven);
        pair.depth.keep(archive);
        // Of the status at that depth no more than this is reported.
        archive(pair.deepest.deepest);
        archive(pair.deepest.thickness);
        const Index none = pair.depth.value > 0 ? -1 : -2, node = pair.deepest.deepest;
        if (node <= none || node >= Index(model_.mesh.points.size()))
            throw Error(ExitCode::checkpoint, "the record of the run names no node of the mesh");
        pair.sliding.keep(archive);
        archive(pair.since);
    }
}

void ContactHealth::addRows(HealthRows& rows) const
{
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
        addDepth(pair, rows);
        addFriction(pair, rows);
    }
}

void ContactHealth::addDepth(std::size_t pair, HealthRows& rows) const
{
    const OfPair& of = pairs_[pair];
    const std::string name = "pair " + model_.contactPairs[pair].name;
    if (!(of.depth.value > 0) || !(of.size > 0)) {
        rows.push_back(
            {"penetration / width of a face", 0, HealthLimits::depthOfFace, name, -1, false, ""});
        return;
    }
    const double ofFace = of.depth.value / of.size,
                 ofThickness = of.deepest.thickness > 0 ? of.depth.value / of.deepest.thickness : 0;
    const Point& start = model_.mesh.points[std::size_t(of.deepest.deepest)];
    const std::string where =
        format("{}, {} deep at node {}, before the run at ({} {} {})", name, of.depth.value,
               of.deepest.deepest, start[0], start[1], start[2]);
    const std::string advice = "the surfaces lie far inside one another: a larger normalScale, "
                               "smaller elements where they meet, or a slower approach";
    rows.push_back({"penetration / width of a face", ofFace, HealthLimits::depthOfFace, where,
                    of.depth.time, ofFace > HealthLimits::depthOfFace, advice});
    if (ofThickness > 0)
        rows.push_back({"penetration / thickness of the target", ofThickness,
                        HealthLimits::depthOfThickness, name, of.depth.time,
                        ofThickness > HealthLimits::depthOfThickness, advice});
}

void ContactHealth::addFriction(std::size_t pair, HealthRows& rows) const
{
    const Sliding& sliding = pairs_[pair].sliding;
    if (!sliding.isJudged()) return;
    rows.push_back(
        {"friction while sliding / friction of Coulomb", sliding.ratio(), HealthLimits::friction,
         "pair " + model_.contactPairs[pair].name, sliding.worstTime(),
         sliding.ratio() < HealthLimits::friction,
         !model_.contactPairs[pair].hasSprings()
             ? "the body chatters, so that contactors stick by turns: springs with their "
               "damping ('enforcement penalty;') calm it"
             : "body and contact chatter, so that contactors stick by turns: damping of "
               "the friction (friction { static ...; damping 0.5; }), normalDamping and "
               "bulkViscosity calm them"});
}

void ContactHealth::addCounts(Solver& solver, HealthRows& rows) const
{
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
        const PairForce force = solver.contact().force(pair);
        for (std::size_t loss = 0; loss < losses.size(); ++loss) {
            const double count = double(force.*losses[loss].count),
                         since = pairs_[pair].since[loss];
            if (count > 0)
                rows.push_back(
                    {losses[loss].figure, count, 0, "pair " + model_.contactPairs[pair].name,
                     since < 0 ? solver.clock().time : since, true, losses[loss].advice});
        }
    }
}

} // namespace fpm
