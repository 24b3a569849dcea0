#include "stability/Scene.h"

#include "mesh/addBox.h"
#include "stability/SceneTools.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

constexpr double waveSpeed = 5.9e6; // of aluminium, mm/s

Part partOf(const std::string& name, double densityRatio = 1, double stiffnessRatio = 1)
{
    Part part = aluminiumPart(name);
    part.density *= densityRatio;
    part.youngsModulus *= stiffnessRatio;
    return part;
}

void watch(Trial& trial, const ContactPair& pair, double depth)
{
    trial.upper = pair.contactorNodes;
    trial.lower = nodesOf(trial.model.mesh, pair.targetSides);
    trial.passed = depth;
}

Index cellsFor(double count)
{
    return std::max<Index>(1, Index(std::lround(count)));
}

/// Two bars meet end to end at a thousandth of the wave speed.
Trial twoBars(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const Index fine = cellsFor(2 * set.of(parameter::mesh, 1));
    addBox(model.mesh, "lower", {2, 2, 12}, {0, 0, -12}, {2, 2, 12});
    addBox(model.mesh, "upper", {fine, fine, cellsFor(6.0 * fine)},
           {0, 0, set.of(parameter::gap, 0)}, {2, 2, 12});
    model.parts = {partOf("lower"),
                   partOf("upper", set.of(parameter::density, 1), set.of(parameter::stiffness, 1))};
    finishScene(model);
    throwPart(model, "upper", {0, 0, -1e-3 * waveSpeed});
    watch(trial,
          addContact(model, "ends", facing(model.mesh, "upper", {0, 0, -1}),
                     facing(model.mesh, "lower", {0, 0, 1})),
          0.5);
    return trial;
}

/// A small block falls askew on a larger one whose mesh does not match.
Trial twoBlocks(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const double ratio = set.of(parameter::mesh, 1);
    addBox(model.mesh, "lower", {6, 5, 3}, {-2, -2, -3}, {9, 8, 3});
    addBox(model.mesh, "upper", {cellsFor(4 * ratio), cellsFor(3 * ratio), cellsFor(3 * ratio)},
           {0, 0, 0}, {5, 4, 4});
    model.parts = {partOf("lower"),
                   partOf("upper", set.of(parameter::density, 1), set.of(parameter::stiffness, 1))};
    finishScene(model);
    throwPart(model, "upper", {2e-4 * waveSpeed, 1e-4 * waveSpeed, -1e-3 * waveSpeed});
    ContactPair& pair = addContact(model, "touch", facing(model.mesh, "upper", {0, 0, -1}),
                                   facing(model.mesh, "lower", {0, 0, 1}));
    pair.friction = 0.3;
    watch(trial, pair, 0.5);
    return trial;
}

/// A free block turns fast about a skew axis while its hourglass modes ring.
Trial spinningBlock(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const double height = 4 / set.of(parameter::aspect, 1);
    addBox(model.mesh, "block", {4, 4, 4}, {-2, -2, -height / 2}, {4, 4, height});
    model.parts = {partOf("block")};
    finishScene(model);
    InitialVelocity spin;
    spin.name = "spin";
    spin.nodes = nodesOfPart(model.mesh, 0);
    const double rate = 1e-3 * waveSpeed;
    spin.spin = {0.3 * rate, 0.5 * rate, 0.8 * rate};
    spin.rotates = true;
    model.initialVelocities.push_back(spin);
    InitialVelocity ring;
    ring.name = "ring";
    ring.rotates = true; // adds to the spin
    for (Index node = 0; node < Index(model.mesh.points.size()); ++node) {
        const Point& x = model.mesh.points[std::size_t(node)];
        if ((std::lround(x[0]) + std::lround(x[1])) % 2 == 0) ring.nodes.push_back(node);
    }
    ring.velocity = {0, 0, 1e-4 * waveSpeed};
    model.initialVelocities.push_back(ring);
    return trial;
}

/// A block slides over the edge of the one below and hangs over it.
Trial slidingCorner(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const Index fine = cellsFor(4 * set.of(parameter::mesh, 1));
    addBox(model.mesh, "lower", {6, 6, 2}, {0, 0, -2}, {6, 6, 2});
    addBox(model.mesh, "upper", {fine, fine, fine}, {3.3, 1.2, 0}, {4, 3.6, 3});
    model.parts = {partOf("lower"), partOf("upper")};
    finishScene(model);
    throwPart(model, "upper", {2e-3 * waveSpeed, 3e-4 * waveSpeed, -5e-4 * waveSpeed});
    // The whole skin of the lower block: the corner of the upper one meets its edge.
    ContactPair& pair = addContact(model, "corner", facing(model.mesh, "upper", {0, 0, -1}),
                                   skin(model.mesh, model.mesh.findPart("lower")));
    pair.friction = 0.3;
    return trial;
}

/// Three thin layers in contact, struck by a block.
Trial thinLayers(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const double thickness = 1 / set.of(parameter::aspect, 4);
    for (int layer = 0; layer < 3; ++layer) {
        const std::string name = "layer" + std::to_string(layer + 1);
        addBox(model.mesh, name, {8, 8, 1}, {0, 0, -(layer + 1) * thickness}, {8, 8, thickness});
        model.parts.push_back(partOf(name));
    }
    addBox(model.mesh, "striker", {3, 3, 3}, {2.6, 2.6, 0}, {3, 3, 3});
    model.parts.push_back(partOf("striker", 2.9, 3));
    finishScene(model);
    throwPart(model, "striker", {0, 0, -1e-3 * waveSpeed});
    watch(trial,
          addContact(model, "strike", facing(model.mesh, "striker", {0, 0, -1}),
                     facing(model.mesh, "layer1", {0, 0, 1})),
          0.5 * thickness);
    for (int layer = 1; layer < 3; ++layer)
        addContact(model, "between" + std::to_string(layer),
                   facing(model.mesh, "layer" + std::to_string(layer), {0, 0, -1}),
                   facing(model.mesh, "layer" + std::to_string(layer + 1), {0, 0, 1}));
    return trial;
}

/// A plastic billet squeezed between two planes, with friction.
Trial compressedBillet(const Setting& set)
{
    Trial trial;
    Model& model = trial.model;
    const double height = 4 / set.of(parameter::aspect, 1);
    addBox(model.mesh, "billet", {4, 4, 4}, {-2, -2, -height / 2}, {4, 4, height});
    Part part = partOf("billet");
    part.kind = PartKind::elastoplastic;
    part.hardening = {{0, 285}, {1, 1185}};
    model.parts = {part};
    finishScene(model);
    const double speed = 2e-3 * waveSpeed * set.of(parameter::speed, 1);
    for (const double sense : {1.0, -1.0}) {
        RigidSurface plane;
        plane.name = sense > 0 ? "above" : "below";
        plane.kind = RigidSurface::Kind::plane;
        plane.point = {0, 0, sense * height / 2};
        plane.axis = {0, 0, -sense};
        plane.motion = RigidSurface::Motion::velocity;
        plane.value = {0, 0, -sense * speed};
        model.rigidSurfaces.push_back(plane);
        const auto sides = facing(model.mesh, "billet", {0, 0, sense});
        ContactPair pair;
        pair.name = plane.name;
        pair.contactorNodes = nodesOf(model.mesh, sides);
        pair.surface = Index(model.rigidSurfaces.size()) - 1;
        pair.friction = 0.1;
        pair.enforcement = Enforcement::penalty; // maps ask about springs
        model.mesh.contact.push_back({pair.name, pair.contactorNodes, sides, {}});
        model.contactPairs.push_back(pair);
    }
    trial.staysClosed = true;
    return trial;
}

} // namespace

void applyCommon(Model& model, const Setting& setting)
{
    const double speed = setting.of(parameter::speed, 1);
    for (InitialVelocity& initial : model.initialVelocities)
        for (std::size_t c = 0; c < 3; ++c) {
            initial.velocity[c] *= speed;
            initial.spin[c] *= speed;
        }
    for (ContactPair& pair : model.contactPairs)
        pair.normalScale = setting.of(parameter::penalty, pair.normalScale);
    for (Part& part : model.parts)
        part.hourglassCoefficient = setting.of(parameter::hourglass, part.hourglassCoefficient);
    model.control.searchInterval =
        int(std::lround(setting.of(parameter::search, double(model.control.searchInterval))));
}

const std::vector<Scene>& probeScenes()
{
    using namespace parameter;
    static const std::vector<std::string> common{timeStep, penalty, speed, search, hourglass};
    const auto with = [](std::vector<std::string> more) {
        more.insert(more.begin(), common.begin(), common.end());
        return more;
    };
    static const std::vector<Scene> scenes{
        {"twoBars", with({mesh, density, stiffness, gap}), twoBars},
        {"twoBlocks", with({mesh, density, stiffness}), twoBlocks},
        {"spinningBlock", {timeStep, speed, hourglass, aspect}, spinningBlock},
        {"slidingCorner", with({mesh}), slidingCorner},
        {"thinLayers", with({aspect}), thinLayers},
        {"compressedBillet", {timeStep, penalty, speed, hourglass, aspect}, compressedBillet}};
    return scenes;
}

Scene caseScene(Model model)
{
    model.control.backend = "serial";
    using namespace parameter;
    return {"case",
            {timeStep, penalty, speed, search, hourglass},
            [model = std::move(model)](const Setting&) {
                Trial trial;
                trial.model = model;
                return trial;
            }};
}

} // namespace fpm
