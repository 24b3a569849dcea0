#include "model/GeneralContact.h"

#include "mesh/Surface.h"
#include "model/ContactReader.h"
#include "model/InitialDepth.h"

#include <algorithm>
#include <set>

namespace fpm {

namespace {

/// A part's skin and the box around it.
struct Body {
    std::vector<ElementSide> sides;
    std::vector<Index> nodes;
    Point least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
    bool meets(const Body& other) const
    {
        for (std::size_t c = 0; c < 3; ++c)
            if (most[c] < other.least[c] || other.most[c] < least[c]) return false;
        return true;
    }
};

std::vector<Body> bodiesOf(const Mesh& mesh)
{
    std::vector<Body> bodies(mesh.parts.size());
    for (std::size_t part = 0; part < bodies.size(); ++part) {
        Body& body = bodies[part];
        body.sides = skin(mesh, Index(part));
        body.nodes = nodesOf(mesh, body.sides);
        for (const Index node : body.nodes)
            for (std::size_t c = 0; c < 3; ++c) {
                const double x = mesh.points[std::size_t(node)][c];
                body.least[c] = std::min(body.least[c], x);
                body.most[c] = std::max(body.most[c], x);
            }
    }
    return bodies;
}

} // namespace

ContactSurfaces allSurfaces(const Mesh& mesh, const std::string& name)
{
    ContactSurfaces surfaces;
    surfaces.pair = name;
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        const std::vector<ElementSide> sides = skin(mesh, Index(part));
        surfaces.targetSides.insert(surfaces.targetSides.end(), sides.begin(), sides.end());
    }
    std::sort(surfaces.targetSides.begin(), surfaces.targetSides.end());
    surfaces.contactorSides = surfaces.targetSides;
    surfaces.contactorNodes = nodesOf(mesh, surfaces.contactorSides);
    return surfaces;
}

std::vector<std::array<Index, 2>> meetingsOf(const Mesh& mesh, const ContactSurfaces& surfaces)
{
    std::set<Index> contactor, target;
    for (const ElementSide& side : surfaces.contactorSides)
        contactor.insert(mesh.partOf(side.element));
    for (const ElementSide& side : surfaces.targetSides) target.insert(mesh.partOf(side.element));
    std::vector<std::array<Index, 2>> parts;
    for (const Index a : contactor)
        for (const Index b : target) parts.push_back({a, b});
    return parts;
}

std::vector<ContactSurfaces> meetingBodies(const Mesh& mesh,
                                           const std::vector<bool>& rigid,
                                           const std::vector<ContactSurfaces>& pairs)
{
    std::set<std::array<Index, 2>> apart;
    for (const ContactSurfaces& pair : pairs)
        for (const auto& [a, b] : meetingsOf(mesh, pair)) apart.insert({{a, b}, {b, a}});
    const std::vector<Body> bodies = bodiesOf(mesh);
    std::vector<ContactSurfaces> out;
    for (std::size_t a = 0; a < bodies.size(); ++a)
        for (std::size_t b = 0; b < bodies.size(); ++b)
            if (a != b && bodies[a].meets(bodies[b]) && !(rigid[a] && rigid[b])
                && !apart.count({Index(a), Index(b)}))
                out.push_back({mesh.parts[a].name + " in " + mesh.parts[b].name, bodies[a].nodes,
                               bodies[a].sides, bodies[b].sides});
    return out;
}

void refuseDeepBodies(const Mesh& mesh,
                      const std::vector<bool>& rigid,
                      const std::vector<ContactSurfaces>& pairs,
                      const Dictionary& contactDict)
{
    for (const ContactSurfaces& two : meetingBodies(mesh, rigid, pairs))
        refuseDeepStart(mesh, two, 1, contactDict, generalContact);
}

} // namespace fpm
