#include "mesh/addBox.h"
#include "stability/CatalogueScenes.h"
#include "stability/SceneTools.h"

#include <cmath>

namespace fpm {

namespace {

/// A body held inside another: what contact does then is search and geometry alone.
struct Held {
    Model model;
    double expected = 0; ///< force along z by hand
};

/// Spring of a face, s K A^2 / V with s = 1 and V = A times thickness.
double springOf(const Part& part, double area, double thickness)
{
    return part.youngsModulus / (3 * (1 - 2 * part.poissonsRatio)) * area / thickness;
}

/// How far the force between the bodies is from that by hand.
double forceError(const Held& held, ContactVariant variant)
{
    const auto solver = startedSolver(asVariant(held.model, variant));
    return std::abs(solver->contact().force(0).force[2] / held.expected - 1);
}

void holdAll(Model& model)
{
    holdFixed(model, nodesWhere(model.mesh, [](Point) { return true; }));
}

constexpr double depth = 0.05;

/// F2: a sheet of faces five times as long as wide, sheared by 60 degrees, and on it a plate that
/// has the same outline but another, square mesh.
Held shearedFaces()
{
    Held held;
    Model& model = held.model;
    const auto shear = [](Point p) { return Point{p[0] + std::sqrt(3.0) * p[1], p[1], p[2]}; };
    addBox(model.mesh, "sheet", {16, 16, 1}, {0, 0, -1}, {16, 3.2, 1});
    addBox(model.mesh, "plate", {61, 13, 1}, {0.35, 0.15, -depth}, {15.3, 2.9, 1});
    for (Point& p : model.mesh.points) p = shear(p);
    finishScene(model);
    model.parts = {aluminiumPart("sheet"), aluminiumPart("plate")};
    addContact(model, "touch", facing(model.mesh, "plate", {0, 0, -1}),
               facing(model.mesh, "sheet", {0, 0, 1}));
    holdAll(model);
    held.expected = 62 * 14 * depth * springOf(model.parts[0], 1 * 0.2, 1);
    return held;
}

/// F3: one face of 5 x 5 beside a strip of faces of 0.25, and a fine plate on the large one.
Held largeFace()
{
    Held held;
    Model& model = held.model;
    addBox(model.mesh, "large", {1, 1, 1}, {0, 0, -1}, {5, 5, 1});
    addBox(model.mesh, "strip", {8, 20, 1}, {5, 0, -1}, {2, 5, 1});
    addBox(model.mesh, "plate", {18, 18, 1}, {0.3, 0.3, -depth}, {4.5, 4.5, 1});
    finishScene(model);
    model.parts = {aluminiumPart("large"), aluminiumPart("strip"), aluminiumPart("plate")};
    std::vector<ElementSide> target = facing(model.mesh, "large", {0, 0, 1});
    for (const ElementSide& side : facing(model.mesh, "strip", {0, 0, 1})) target.push_back(side);
    addContact(model, "touch", facing(model.mesh, "plate", {0, 0, -1}), target);
    holdAll(model);
    held.expected = 19 * 19 * depth * springOf(model.parts[0], 25, 1);
    return held;
}

/// F23, F25: two sheets of one height in contact along x = 4, their nodes not shared or, `merged`,
/// one sheet; a plate over both, some of its nodes nearer to the seam than they are deep.
Held meshSeam(bool merged)
{
    Held held;
    Model& model = held.model;
    std::vector<std::string> sheets{"left"};
    addBox(model.mesh, "left", {merged ? 8 : 4, 4, 1}, {0, 0, -1}, {merged ? 8.0 : 4.0, 4, 1});
    if (!merged) {
        addBox(model.mesh, "right", {4, 4, 1}, {4, 0, -1}, {4, 4, 1});
        sheets.push_back("right");
    }
    addBox(model.mesh, "plate", {24, 14, 1}, {0.43, 0.25, -depth}, {7.2, 3.5, 1});
    finishScene(model);
    std::vector<ElementSide> target;
    for (const std::string& sheet : sheets) {
        model.parts.push_back(aluminiumPart(sheet));
        for (const ElementSide& side : facing(model.mesh, sheet, {0, 0, 1})) target.push_back(side);
    }
    model.parts.push_back(aluminiumPart("plate"));
    addContact(model, "touch", facing(model.mesh, "plate", {0, 0, -1}), target);
    holdAll(model);
    held.expected = 25 * 15 * depth * springOf(model.parts[0], 1, 1);
    return held;
}

/// Share of the contactors that have less than their force by hand.
Measure lostAtSeam(ContactVariant variant)
{
    const Held held = meshSeam(false);
    const auto solver = startedSolver(asVariant(held.model, variant));
    const NodeValues values = solver->nodes().values(held.model.contactPairs[0].contactorNodes);
    double lost = 0;
    for (std::size_t i = 0; i < values.count; ++i)
        lost += values.at(3, i)[2] < 0.999 * held.expected / double(values.count);
    return {lost / double(values.count), {}};
}

/// F4: the corner of a cube pushed into the flat end of a block that stands askew: the end is cut
/// by three faces, three edges and the corner. Share of its nodes inside that no spring holds.
Measure cornerInFace(ContactVariant variant)
{
    constexpr double cut = 0.5; // of the corner, along the diagonal
    Model model;
    addBox(model.mesh, "cube", {4, 4, 4}, {-4, -4, -4}, {4, 4, 4});
    addBox(model.mesh, "block", {30, 30, 1}, {-1.53, -1.49, -cut}, {3, 3, 1});
    const double a = 1 / std::sqrt(2.0), b = 1 / std::sqrt(6.0), c = 1 / std::sqrt(3.0);
    for (const Index node : nodesOfPart(model.mesh, "block")) {
        Point& p = model.mesh.points[std::size_t(node)]; // along (1 -1 0), (1 1 -2), (1 1 1)
        p = {a * p[0] + b * p[1] + c * p[2], -a * p[0] + b * p[1] + c * p[2],
             -2 * b * p[1] + c * p[2]};
    }
    finishScene(model);
    model.parts = {aluminiumPart("cube"), aluminiumPart("block")};
    addContact(model, "touch", facing(model.mesh, "block", {-c, -c, -c}),
               skin(model.mesh, model.mesh.findPart("cube")));
    holdAll(model);
    double inside = 0;
    for (const Index node : model.contactPairs[0].contactorNodes) {
        const Point& p = model.mesh.points[std::size_t(node)];
        if (std::max({p[0], p[1], p[2]}) < 0) ++inside;
    }
    const auto solver = startedSolver(asVariant(model, variant));
    return {std::abs(double(solver->contact().force(0).active) / inside - 1), {}};
}

/// F1: a groove of 20 degrees, one long face on its left flank, eight on the right; a node is led
/// from flank to flank. Share of the steps inside a flank that are without contact.
Measure grooveNode(ContactVariant variant)
{
    const double slope = std::tan(80 * M_PI / 180), height = 4.9, speed = 1e6;
    Model model;
    addBox(model.mesh, "groove", {9, 2, 1}, {-1, 0, -1}, {9, 10, 1}); // x: left end at -1
    addBox(model.mesh, "point", {1, 1, 1}, {-1, 4, height}, {1, 1, 1});
    for (const Index node : nodesOfPart(model.mesh, "groove")) {
        Point& p = model.mesh.points[std::size_t(node)];
        p[0] = p[0] < -0.5 ? -2 : p[0] / 4;
        p[2] = 10 * p[2] + slope * std::abs(p[0]);
    }
    finishScene(model);
    model.parts = {aluminiumPart("groove"), aluminiumPart("point")};
    addContact(model, "touch", facing(model.mesh, "point", {0, 0, -1}),
               skin(model.mesh, model.mesh.findPart("groove")));
    const Point start{-1, 4, height};
    model.contactPairs[0].contactorNodes = model.mesh.contact[0].contactorNodes =
        nodesWhere(model.mesh, [&](Point p) { return p == start; });
    model.contactPairs[0].targetSides = model.mesh.contact[0].targetSides = [&] {
        std::vector<ElementSide> flanks;
        for (const ElementSide& side : skin(model.mesh, model.mesh.findPart("groove")))
            if (normal(model.mesh, side)[2] > 0.1) flanks.push_back(side);
        return flanks;
    }();
    holdFixed(model, nodesOfPart(model.mesh, "groove"));
    throwPart(model, "point", {speed, 0, 0});
    model.boundaryConditions.push_back(condition(BoundaryCondition::Kind::velocity, "led",
                                                 nodesOfPart(model.mesh, "point"),
                                                 {true, true, true}, {speed, 0, 0}));
    model.control.fixedTimeStep = 2e-9;
    const auto solver = startedSolver(asVariant(model, variant));
    double inside = 0, lost = 0;
    for (double x = -1; x < 1; x = -1 + speed * solver->clock().time) {
        if (height - slope * std::abs(x) < -1e-6) {
            ++inside;
            lost += solver->contact().force(0).active == 0;
        }
        solver->advance(1, 1);
    }
    return {lost / inside, {}};
}

} // namespace

std::vector<Failure> searchFailures()
{
    const std::string exact = "the force by hand, but for rounding";
    return {
        {.number = 1,
         .name = "grooveNode",
         .fails = "The node closest to a contactor in a groove belongs to the opposite flank.",
         .quantity = "share of the steps inside a flank without contact",
         .limit = 0,
         .reason = "a node inside is in contact",
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "search by distance to faces, and only faces that oppose the contactor",
         .note = "the paper's closest particle lies on the wrong flank",
         .run = grooveNode},
        {.number = 2,
         .name = "shearedFaces",
         .fails = "On long sheared faces the closest node is not one of the closest face.",
         .quantity = "error of the force",
         .limit = 1e-9,
         .reason = exact,
         .remedy = "search by distance to faces",
         .note = "the paper's search takes another face for every sixth node, but its projection "
                 "then tests all faces around the corner nearest there, and finds it",
         .run =
             [](ContactVariant variant) {
                 return Measure{forceError(shearedFaces(), variant), {}};
             }},
        {.number = 3,
         .name = "largeFace",
         .fails = "A face much larger than the others has no node near a contactor in its middle.",
         .quantity = "error of the force",
         .limit = 1e-9,
         .reason = exact,
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "each face is entered in a grid of cells of its own size",
         .note = "the cells are wide enough, but nodes of smaller faces beside it are closer",
         .run =
             [](ContactVariant variant) {
                 return Measure{forceError(largeFace(), variant), {}};
             }},
        {.number = 4,
         .name = "cornerInFace",
         .fails = "At convex edges and corners a contactor projects outside of all faces.",
         .quantity = "share of the nodes inside that no spring holds",
         .limit = 0,
         .reason = "a node inside is in contact",
         .remedy = "closest point clamped to the face, angle-weighted normals",
         .note = "algorithm paper clamps as the default does; the printed one has the dead zone",
         .run = cornerInFace},
        {.number = 23,
         .name = "meshSeam",
         .fails = "Contactors fall through between faces whose nodes coincide but are not shared.",
         .quantity = "share of the contactors with less than their force",
         .limit = 0,
         .reason = exact,
         .expected = {Fate::holds, Fate::loses, Fate::none},
         .remedy = "search by distance to faces; fpmSetContact warns of seams",
         .note = "the paper takes one of two particles in one place, and its sheet alone",
         .run = lostAtSeam},
        {.number = 25,
         .name = "edgeOfTwoBodies",
         .fails = "A contactor over the common edge of two bodies is pushed by both: twice the "
                  "penalty.",
         .quantity = "error of the force",
         .limit = 1e-9,
         .reason = exact,
         .expected = {Fate::loses, Fate::loses, Fate::holds},
         .remedy = "one mesh with shared nodes",
         .note =
             "default: nodes nearer to the seam than they are deep (15 of 375) are held by both "
             "bodies; paper: those whose closest particle is taken from the other body by none",
         .run =
             [](ContactVariant variant) {
                 return Measure{forceError(meshSeam(variant == ContactVariant::remedy), variant),
                                {}};
             }},
    };
}

} // namespace fpm
