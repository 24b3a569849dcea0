#pragma once

#include "model/PartMaterial.h"
#include "unit/solver/edgeScenes.h"

#include <cmath>
#include <string>
#include <vector>

namespace fpm::test {

/// A block strikes a larger one and slides; several patches.
inline Model impact(PartKind kind, HourglassForm form)
{
    Model model =
        twoBlocks(aluminium(kind, form), aluminium(PartKind::elastic, HourglassForm::stiffness),
                  {3e4, -2e4, -1e5}, 0.3);
    holdFixed(model, nodesWhere(model.mesh, [](Point p) { return p[2] < -3.99; }));
    return model;
}

inline Model plain()
{
    return impact(PartKind::elastoplastic, HourglassForm::physical);
}

struct Scene {
    std::string name;
    Model model;
};

/// Kinematic hardening, rate and heat.
inline Flow manyOptions()
{
    Flow flow;
    flow.kinematicModulus = 500;
    flow.rate = RateDependence::johnsonCook;
    flow.referenceRate = 1;
    flow.rateCoefficient = 0.01;
    flow.heatFraction = 0.9;
    flow.specificHeat = 9e8;
    flow.softeningExponent = 1;
    flow.meltingTemperature = 900;
    return flow;
}

/// Elements and materials: one scene a kernel, and the options of the general one.
inline void addElements(std::vector<Scene>& scenes)
{
    for (const auto& [name, form] : {std::pair{"stiffness", HourglassForm::stiffness},
                                     std::pair{"viscous", HourglassForm::viscous},
                                     std::pair{"physical", HourglassForm::physical}})
        for (const PartKind kind : {PartKind::elastic, PartKind::elastoplastic}) {
            const std::string material = kind == PartKind::elastic ? "elastic " : "plastic ";
            scenes.push_back({material + name, impact(kind, form)});
            scenes.push_back({"polar " + material + name, impact(kind, form)});
            scenes.back().model.parts[1].rotation = RotationForm::polar;
        }
    Model selective = plain();
    selective.parts[1].hexahedron = HexahedronForm::selective;
    selective.parts[1].rotation = RotationForm::hughesWinget;
    scenes.push_back({"selective", selective});
    const std::pair<PartKind, std::vector<double>> laws[]{
        {kindOf<DruckerPrager>, {100, 20, 10}},
        {kindOf<ZerilliArmstrong>, {65, 0, 890, 0.0028, 0.000115, 0, 1, 1}}};
    for (const auto& [kind, values] : laws)
        for (const HexahedronForm form : {HexahedronForm::reduced, HexahedronForm::selective}) {
            Model listed = plain();
            Part& part = listed.parts[1];
            part.kind = kind;
            part.lawValues = values;
            part.hexahedron = form;
            if (materialOf(kind).heats) part.flow.heatFraction = 0.9;
            part.flow.specificHeat = 9e8;
            scenes.push_back(
                {wordOf(kind) + (form == HexahedronForm::selective ? ", selective" : ""), listed});
        }
    Model general = plain();
    general.parts[1].flow = manyOptions();
    scenes.push_back({"kinematic, rate, heat", general});
    Model tabled = plain();
    tabled.parts[1].hardening = {{0, 285}, {0.01, 300}, {0.05, 320}};
    tabled.parts[1].flow.rate = RateDependence::cowperSymonds;
    tabled.parts[1].flow.referenceRate = 6500;
    tabled.parts[1].flow.rateCoefficient = 0.25;
    tabled.parts[1].hourglassPlastic = HourglassPlastic::elastic;
    scenes.push_back({"table of plastic hardening, rate", tabled});
    Model floats = plain();
    for (Part& part : floats.parts) part.hourglassStorage = HourglassStorage::float_;
    scenes.push_back({"hourglass forces as float", floats});
    Model eroding = plain();
    eroding.parts[1].erosion.plasticStrain = 0.02;
    BoundaryCondition press = condition(BoundaryCondition::Kind::pressure, "press", {}, {}, {50});
    press.sides = facing(eroding.mesh, "upper", {1, 0, 0});
    eroding.boundaryConditions.push_back(press);
    scenes.push_back({"erosion", eroding});
    Model scaled = plain();
    for (Part& part : scaled.parts) part.massFactor = 4;
    scenes.push_back({"mass scaling", scaled});
}

/// Kinds of contact, laws and searches.
inline void addContacts(std::vector<Scene>& scenes)
{
    Model twice = plain(), all = plain(), fold = closingFold(), paper = plain(), damped = plain();
    twice.contactPairs[0].passes = 2;
    scenes.push_back({"two passes", twice});
    all.mesh.contact.clear();
    all.contactPairs.clear();
    addGeneral(all).friction = 0.3;
    scenes.push_back({"general contact", all});
    const std::vector<ElementSide> sides = skin(fold.mesh, 0);
    addContact(fold, "own", sides, sides).kind = ContactKind::self;
    scenes.push_back({"self-contact", fold});
    scenes.push_back({"edges that slide", slidingRoofs()});
    for (Part& part : paper.parts) part.rotation = RotationForm::arcsine;
    paper.control.midStepStrain = false;
    ContactPair& pair = paper.contactPairs[0];
    pair.search = ContactSearch::closestParticle;
    pair.projection = ContactProjection::cold;
    pair.paperFriction = true;
    scenes.push_back({"algorithm of the paper", paper});
    damped.contactPairs[0].normalDamping = 0.2;
    damped.contactPairs[0].dynamicFriction = 0.1;
    damped.contactPairs[0].frictionDecay = 1e-5;
    scenes.push_back({"contact damping, decaying friction", damped});

    Model ramped = twoBlocks(paper.parts[1], paper.parts[0], {0, 0, -1e5}, 0.3, -0.05);
    ramped.contactPairs[0].initialOverlap = InitialOverlap::ramp;
    ramped.contactPairs[0].rampTime = 1e-5;
    ramped.contactPairs[0].penalty = PenaltyRule::series;
    scenes.push_back({"overlap that fades, springs in series", ramped});
}

/// Plane, cylinder and sphere in place of the lower block.
inline void addSurfaces(std::vector<Scene>& scenes, Enforcement enforcement)
{
    using Kind = RigidSurface::Kind;
    for (const auto& [name, kind] :
         {std::pair{"analytic wall", Kind::plane}, std::pair{"moving cylinder", Kind::cylinder},
          std::pair{"moving sphere", Kind::sphere}}) {
        Model model = plain();
        model.mesh.contact.clear();
        model.contactPairs.clear();
        addContact(model, name, facing(model.mesh, "upper", {0, 0, -1}), {}).surface = 0;
        model.contactPairs[0].friction = 0.2;
        model.contactPairs[0].enforcement = enforcement;
        RigidSurface surface;
        surface.name = name;
        surface.kind = kind;
        if (kind != Kind::plane) {
            surface.point = {4, kind == Kind::cylinder ? 0.0 : 3.5, -5};
            surface.axis = {0, 1, 0};
            surface.length = 5;
            surface.radius = 5;
            surface.motion = RigidSurface::Motion::velocity;
            surface.value = {2e4, 0, 5e4};
            surface.amplitude = {Amplitude::Kind::table, {{0, 1}, {1e-5, 0.5}}};
        }
        model.rigidSurfaces.push_back(surface);
        const bool exact = enforcement == Enforcement::kinematic;
        scenes.push_back({std::string(name) + (exact ? ", met exactly" : ", springs"), model});
    }
}

/// Drives, loads, damping, free rigid bodies, relaxation.
inline void addMotions(std::vector<Scene>& scenes)
{
    using Kind = BoundaryCondition::Kind;
    Model body = plain();
    body.parts[1].kind = PartKind::rigidFree;
    body.initialVelocities[0].part = 1;
    scenes.push_back({"free rigid body", body});
    Model driven = plain();
    driven.control.massDamping = 100;
    const auto top = nodesWhere(driven.mesh, [](Point p) { return p[2] > 5.99; });
    driven.boundaryConditions.push_back(
        condition(Kind::velocity, "push", top, {true, false, true}, {1e4, 0, -1e5}));
    BoundaryCondition weight = condition(Kind::gravity, "weight", {}, {}, {0, 0, -1e9});
    weight.parts = {0, 1};
    driven.boundaryConditions.push_back(weight);
    BoundaryCondition press = condition(Kind::pressure, "press", {}, {}, {200, 0, 0});
    press.sides = facing(driven.mesh, "upper", {1, 0, 0});
    driven.boundaryConditions.push_back(press);
    scenes.push_back({"drive, gravity, pressure, damping", driven});
    Model turned = plain();
    BoundaryCondition turn = condition(Kind::rotation, "turn", top, {true, true, true}, {},
                                       {Amplitude::Kind::smooth, {{0, 0}, {3e-5, 1}}});
    turn.line = {{{4, 3.5, 6}, {0, 0, 1}}};
    turn.angle = 2;
    turned.boundaryConditions.push_back(turn);
    const auto bottom = nodesWhere(turned.mesh, [](Point p) { return p[2] < 0.01 && p[2] > -1.5; });
    BoundaryCondition pull =
        condition(Kind::force, "pull", bottom, {true, true, true}, {20, -10, -30});
    pull.axes = {{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}};
    turned.boundaryConditions.push_back(pull);
    const auto side = nodesWhere(turned.mesh, [](Point p) { return p[0] < -1.99 && p[2] > -3.5; });
    BoundaryCondition slide = condition(Kind::displacement, "slide", side, {true, false, false},
                                        {0.02, 0, 0}, turn.amplitude);
    slide.axes = pull.axes;
    turned.boundaryConditions.push_back(slide);
    scenes.push_back({"rotation, force and drive in axes of their own", turned});
    Model relaxing = plain();
    relaxing.control.relaxationTolerance = 1e-6;
    scenes.push_back({"dynamic relaxation", relaxing});
}

/// Blocks of the other scenes lie along the axes and bend little: many products are zero or exact
/// there, and a fused multiply-add tells nothing. Turned by 0.9 about (1 2 3) and bent, no element
/// is a box.
inline Point turned(const Point& p)
{
    const double angle = 0.9, n = std::sqrt(14.0), c = std::cos(angle), s = std::sin(angle);
    const Point axis{1 / n, 2 / n, 3 / n};
    const double along = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    Point out;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = c * p[i] + s * (axis[j] * p[k] - axis[k] * p[j]) + (1 - c) * along * axis[i];
    }
    return out;
}
inline Point bent(const Point& p)
{
    return turned({p[0] + 0.25 * std::sin(0.9 * p[1] + 0.7 * p[2]),
                   p[1] + 0.25 * std::sin(0.8 * p[2] - 0.6 * p[0]),
                   p[2] + 0.25 * std::sin(0.7 * p[0] + 0.9 * p[1])});
}

/// A bent block falls on another, twists and stretches: at 300 m/s plastic strains of a quarter to
/// a half.
inline Model largeStrain(PartKind kind, HourglassForm form, double speed)
{
    Model model = impact(kind, form);
    for (Part& part : model.parts) part = model.parts[1];
    model.parts[0].name = "lower";
    model.initialVelocities.clear();
    for (const Index node : nodesOfPart(model.mesh, "upper")) {
        const Point& p = model.mesh.points[std::size_t(node)];
        const double x = p[0] - 3.5, y = p[1] - 3;
        const Point v{0.3 + 0.15 * x - 0.1 * y, -0.2 + 0.1 * x, -1};
        model.initialVelocities.push_back(
            {"throw", {node}, turned({speed * v[0], speed * v[1], speed * v[2]})});
    }
    for (Point& p : model.mesh.points) p = bent(p);
    return model;
}
/// Every element kernel, contact with friction and without, and the algorithm of the paper.
inline void addLargeStrain(std::vector<Scene>& scenes)
{
    for (const auto& [name, form] : {std::pair{"stiffness", HourglassForm::stiffness},
                                     std::pair{"viscous", HourglassForm::viscous},
                                     std::pair{"physical", HourglassForm::physical}}) {
        Model elastic = largeStrain(PartKind::elastic, form, 5e4);
        elastic.contactPairs[0].friction = 0;
        scenes.push_back({std::string("bent mesh, elastic ") + name, elastic});
        const Model plastic = largeStrain(PartKind::elastoplastic, form, 3e5);
        scenes.push_back({std::string("large strain, plastic ") + name, plastic});
        Model general = plastic;
        for (Part& part : general.parts) part.flow = manyOptions();
        general.parts[0].rotation = RotationForm::polar;
        general.contactPairs[0].normalDamping = 0.2;
        scenes.push_back({std::string("large strain, plastic, options, ") + name, general});
    }
    Model selective = largeStrain(PartKind::elastoplastic, HourglassForm::physical, 3e5);
    for (Part& part : selective.parts) {
        part.hexahedron = HexahedronForm::selective;
        part.rotation = RotationForm::hughesWinget;
    }
    scenes.push_back({"large strain, plastic selective", selective});
    Model paper = largeStrain(PartKind::elastoplastic, HourglassForm::stiffness, 3e5);
    for (Part& part : paper.parts) part.rotation = RotationForm::arcsine;
    paper.contactPairs[0].search = ContactSearch::closestParticle;
    paper.contactPairs[0].projection = ContactProjection::cold;
    scenes.push_back({"large strain, plastic, paper", paper});
}

inline std::vector<Scene> scenes()
{
    std::vector<Scene> all;
    addElements(all);
    addContacts(all);
    addSurfaces(all, Enforcement::kinematic);
    addSurfaces(all, Enforcement::penalty);
    addMotions(all);
    addLargeStrain(all);
    return all;
}

} // namespace fpm::test
