#include "model/ContactLawReader.h"

#include "base/Format.h"
#include "model/BoundaryReader.h"
#include "model/PointAlgebra.h"

#include <algorithm>

namespace fpm {

namespace {

void readFriction(const Dictionary& entry, ContactLaw& law)
{
    law.friction = entry.number("static", nonNegative());
    law.paperFriction = entry.choiceOr("form", "objective", {"objective", "paper"}) == "paper";
    if (law.paperFriction && entry.has("damping"))
        entry.fail("damping", "friction of form paper has no damping", "leave one of the two out");
    law.slipDamping = entry.numberOr("damping", law.slipDamping, between(0, 0.5));
    const bool slows = entry.has("dynamic");
    if (slows != entry.has("decay"))
        entry.fail(slows ? "dynamic" : "decay", "'dynamic' and 'decay' are given together",
                   "such as: friction { static 0.4; dynamic 0.3; decay 1e-3; }");
    if (!slows) return;
    law.dynamicFriction = entry.number("dynamic", nonNegative());
    law.frictionDecay = entry.number("decay", positive());
    if (law.dynamicFriction > law.friction)
        entry.fail(
            "dynamic",
            format("dynamic friction {} is above the static {}", law.dynamicFriction, law.friction),
            "a body that slides is held less than one that sticks");
}

/// Exact against analytic surfaces unless springs are asked for; then what shapes springs has no
/// meaning.
Enforcement readEnforcement(const Dictionary& pair, bool analytic)
{
    const std::string word =
        pair.choiceOr("enforcement", analytic ? "kinematic" : "penalty", {"kinematic", "penalty"});
    if (word == "penalty") return Enforcement::penalty;
    if (!analytic)
        pair.fail("enforcement",
                  "kinematic enforcement needs a plane, cylinder or sphere as target",
                  "remove the entry: faces press by springs; or let the target be an entry of "
                  "'surfaces' with a 'type'");
    const std::string instead = "remove the entry; or write 'enforcement penalty;' for springs";
    for (const char* key : {"normalScale", "tangentialScale", "penalty", "normalDamping"})
        if (pair.has(key))
            pair.fail(key,
                      format("'{}' shapes springs, and an analytic surface is met exactly, "
                             "without springs",
                             key),
                      instead);
    if (!pair.isDictionary("friction")) return Enforcement::kinematic;
    for (const char* key : {"form", "damping"})
        if (const Dictionary friction = pair.sub("friction"); friction.has(key))
            friction.fail(
                key,
                format("'{}' is for the elastic slip of springs, and an analytic surface is met "
                       "exactly, without springs",
                       key),
                instead);
    return Enforcement::kinematic;
}

Point direction(const Dictionary& entry, const std::string& key)
{
    const Point v = entry.vector(key);
    const double size = length(v);
    if (size == 0) entry.fail(key, "the direction (0 0 0) points nowhere");
    return along({0, 0, 0}, 1 / size, v);
}

void readCylinder(const Dictionary& entry, RigidSurface& surface)
{
    const auto ends = entry.rows("axis", 3);
    if (ends.size() != 2)
        entry.fail("axis", "a cylinder needs the two ends of its axis",
                   "such as: axis ((0 -100 50) (0 100 50));");
    surface.point = {ends[0][0], ends[0][1], ends[0][2]};
    const Point axis = difference({ends[1][0], ends[1][1], ends[1][2]}, surface.point);
    surface.length = length(axis);
    if (surface.length == 0) entry.fail("axis", "the axis of the cylinder has no length");
    surface.axis = along({0, 0, 0}, 1 / surface.length, axis);
    surface.infinite = entry.switchOr("infinite", false);
}

void readMotion(const Dictionary& entry, RigidSurface& surface)
{
    using Motion = RigidSurface::Motion;
    const bool moved = entry.has("displacement");
    if (moved == entry.has("velocity"))
        entry.fail(moved ? "velocity" : "displacement",
                   moved ? "both 'displacement' and 'velocity' are given" : "nothing moves",
                   "give 'displacement (x y z);' or 'velocity (x y z);', and an amplitude");
    const std::string key = moved ? "displacement" : "velocity";
    surface.motion = moved ? Motion::displacement : Motion::velocity;
    surface.value = entry.vector(key);
    surface.amplitude = readAmplitude(entry);
    if (moved) refuseJump(entry, "displacement", key, surface.amplitude(0) * length(surface.value));
}

} // namespace

ContactLaw readContactLaw(const Dictionary& pair, bool analytic)
{
    const Range scale{0, 100, true, false};
    ContactLaw law;
    law.enforcement = readEnforcement(pair, analytic);
    if (pair.isDictionary("friction"))
        readFriction(pair.sub("friction"), law);
    else
        law.friction = pair.numberOr("friction", 0.0, nonNegative());
    law.normalScale = pair.numberOr("normalScale", law.normalScale, scale);
    law.tangentialScale = pair.numberOr("tangentialScale", law.tangentialScale, scale);
    std::vector<std::string> words;
    for (const PenaltyEntry& rule : penaltyEntries) words.push_back(rule.word);
    const std::string word = pair.choiceOr("penalty", entryOf(law.penalty).word, words);
    law.penalty = PenaltyRule(int(std::find(words.begin(), words.end(), word) - words.begin()));
    // Steady sliding needs a little of it (doc/defaults.md).
    const bool slides =
        law.friction > 0 && !law.paperFriction && law.enforcement == Enforcement::penalty;
    law.normalDamping = pair.numberOr("normalDamping", slides ? 0.05 : 0.0, between(0, 1));
    return law;
}

RigidSurface readRigidSurface(const Dictionary& entry, const std::string& name)
{
    using Kind = RigidSurface::Kind;
    RigidSurface surface;
    surface.name = name;
    const std::string type = entry.choice("type", {"plane", "cylinder", "sphere"});
    surface.kind = type == "plane"      ? Kind::plane
                   : type == "cylinder" ? Kind::cylinder
                                        : Kind::sphere;
    if (surface.kind == Kind::plane) {
        surface.point = entry.vector("point");
        surface.axis = direction(entry, "normal");
    } else {
        if (surface.kind == Kind::cylinder)
            readCylinder(entry, surface);
        else
            surface.point = entry.vector("centre");
        surface.radius = entry.number("radius", positive());
        surface.inside = entry.choiceOr("side", "outside", {"outside", "inside"}) == "inside";
    }
    if (entry.has("motion")) readMotion(entry.sub("motion"), surface);
    return surface;
}

} // namespace fpm
