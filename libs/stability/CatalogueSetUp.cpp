#include "base/Error.h"
#include "mesh/Patches.h"
#include "mesh/Quality.h"
#include "mesh/addBox.h"
#include "model/ContactSetup.h"
#include "stability/CatalogueScenes.h"
#include "stability/SceneTools.h"

namespace fpm {

namespace {

/// Two blocks, the upper one a little above the lower.
Mesh twoBlocks()
{
    Mesh mesh;
    addBox(mesh, "lower", {4, 4, 2}, {0, 0, 0}, {4, 4, 1});
    addBox(mesh, "upper", {3, 3, 1}, {1, 1, 1.1}, {2, 2, 1});
    renumber(mesh);
    return mesh;
}

/// What `work` logs, or says when it refuses.
Measure saidBy(const std::function<void(Log&)>& work)
{
    Measure out;
    Log log = Log::into(out.said);
    try {
        work(log);
    } catch (const Error& error) {
        out.said += error.what();
        out.stopped = true;
    }
    return out;
}

Measure saidOf(Mesh mesh, const std::string& contactDict, std::vector<bool> rigid = {})
{
    rigid.resize(mesh.parts.size(), false);
    return saidBy([&](Log& log) { setContact(mesh, Dictionary::parse(contactDict), rigid, log); });
}

Measure inwardFaces(ContactVariant)
{
    Mesh mesh = twoBlocks();
    mesh.sideSets["foot"] = facing(mesh, "upper", {0, 0, -1});
    mesh.sideSets["base"] = facing(mesh, "lower", {0, 0, -1});
    return saidOf(mesh, "pairs { press { contactor foot; target base; } }");
}

Measure unmergedNodes(ContactVariant)
{
    Mesh mesh;
    addBox(mesh, "left", {2, 4, 1}, {0, 0, 0}, {2, 4, 1});
    addBox(mesh, "right", {2, 4, 1}, {2, 0, 0}, {2, 4, 1});
    addBox(mesh, "upper", {2, 2, 1}, {1, 1, 1.1}, {2, 2, 1});
    renumber(mesh);
    std::vector<ElementSide> top = facing(mesh, "left", {0, 0, 1});
    for (const ElementSide& side : facing(mesh, "right", {0, 0, 1})) top.push_back(side);
    mesh.sideSets["top"] = top;
    return saidOf(mesh, "pairs { press { contactor upper; target top; } }");
}

Measure rigidOnRigid(ContactVariant)
{
    return saidOf(twoBlocks(), "pairs { press { contactor upper; target lower; } }", {true, true});
}

Measure doubledPair(ContactVariant)
{
    Mesh mesh = twoBlocks();
    mesh.sideSets["foot"] = facing(mesh, "upper", {0, 0, -1});
    return saidOf(mesh, "pairs { one { contactor upper; target lower; }"
                        "other { contactor foot; target lower; } }");
}

/// An element whose side is a triangle, as wedges in hexahedra are written.
Measure wedgeElements(ContactVariant)
{
    Mesh mesh = twoBlocks();
    Hexahedron& element = mesh.hexahedra.front();
    element[3] = element[2];
    element[7] = element[6];
    return saidBy([&](Log& log) { checkMesh(mesh, "mesh", log); });
}

} // namespace

std::vector<Failure> setUpFailures()
{
    return {
        {.number = 10,
         .name = "inwardFaces",
         .fails = "A target whose normals point away draws the contactors in.",
         .quantity = "what is said",
         .words = "all contactor nodes lie behind the target",
         .expected = {Fate::refused, Fate::refused, Fate::none},
         .remedy = "sides of elements, so that normals point outwards; the start is checked",
         .run = inwardFaces},
        {.number = 23,
         .name = "unmergedNodes",
         .fails = "A seam in the target is not noticed.",
         .quantity = "what is said",
         .words = "10 target nodes lie on one another without being one",
         .expected = {Fate::warned, Fate::warned, Fate::none},
         .remedy = "merge the nodes",
         .run = unmergedNodes},
        {.number = 24,
         .name = "rigidOnRigid",
         .fails = "Between two rigid bodies no mass limits the force.",
         .quantity = "what is said",
         .words = "parts 'upper' and 'lower' are both rigid: no mass limits the contact force",
         .expected = {Fate::refused, Fate::refused, Fate::none},
         .remedy = "make one of them deformable",
         .run = rigidOnRigid},
        {.number = 25,
         .name = "doubledPair",
         .fails = "Two pairs hold the same nodes on the same faces: twice the penalty.",
         .quantity = "what is said",
         .words = "share 16 contactor nodes and",
         .expected = {Fate::warned, Fate::warned, Fate::none},
         .remedy = "one pair a set of nodes and faces",
         .run = doubledPair},
        {.number = 26,
         .name = "wedgeElements",
         .fails = "At a face with two corners in one node tangents are parallel: no normal.",
         .quantity = "what is said",
         .words = "elements that name a node twice",
         .expected = {Fate::refused, Fate::refused, Fate::none},
         .remedy = "mesh with hexahedra; corners that merely lie close are projected on",
         .run = wedgeElements},
    };
}

} // namespace fpm
