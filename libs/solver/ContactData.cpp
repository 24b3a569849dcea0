#include "base/Error.h"
#include "base/Format.h"
#include "kernels/contact/PairView.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "solver/SolverData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fpm {

namespace {

/// K A^2 / V of the element behind a side: the penalty of Hallquist et al. 1985.
double penalty(const Model& model, const ElementSide& side)
{
    const Part& part = model.parts[std::size_t(model.mesh.partOf(side.element))];
    const double bulk = part.youngsModulus / (3 * (1 - 2 * part.poissonsRatio));
    const double a = area(model.mesh, side);
    return bulk * a * a / volume(model.mesh, side.element);
}

bool isRigid(const Model& model, const ElementSide& side)
{
    return model.parts[std::size_t(model.mesh.partOf(side.element))].kind == PartKind::rigid;
}

/// Sides of the contactor's surface, from the mesh; the contactor's nodes lie on them.
const std::vector<ElementSide>& ownSides(const Model& model, const ContactPair& pair)
{
    for (const ContactSurfaces& surfaces : model.mesh.contact)
        if (surfaces.pair == pair.name) return surfaces.contactorSides;
    throw Error(ExitCode::mesh,
                format("the mesh holds no surfaces of contact pair '{}'", pair.name),
                "run fpmSetContact");
}

void addOwnFaces(PairData& out, const Model& model, const std::vector<ElementSide>& sides)
{
    std::map<Index, std::vector<Quad>> around;
    for (const ElementSide& side : sides) {
        const Quad quad = model.mesh.sideNodes(side);
        for (const Index node : quad) around[node].push_back(quad);
    }
    out.ownFaceStart.push_back(0);
    for (const Index node : out.contactor) {
        for (const Quad& quad : around[node])
            out.ownFaceNode.insert(out.ownFaceNode.end(), quad.begin(), quad.end());
        out.ownFaceStart.push_back(Index(out.ownFaceNode.size() / 4));
    }
}

/// Bodies of faces and contactors, where there are several or some may not meet.
void addComponents(PairData& out,
                   const Model& model,
                   const ContactPair& pair,
                   const std::vector<ElementSide>& own,
                   const std::vector<ElementSide>& target)
{
    const auto bodyOf = [&](const ElementSide& side) { return model.mesh.partOf(side.element); };
    for (const ElementSide& side : target) out.faceComponent.push_back(bodyOf(side));
    const auto [least, most] =
        std::minmax_element(out.faceComponent.begin(), out.faceComponent.end());
    if (pair.kind != ContactKind::general
        && (*least == *most || pair.search == ContactSearch::closestParticle)) {
        out.faceComponent.clear();
        return;
    }
    std::map<Index, Index> body;
    for (const ElementSide& side : own)
        for (const Index node : model.mesh.sideNodes(side)) body[node] = bodyOf(side);
    for (const Index node : out.contactor) out.contactorComponent.push_back(body[node]);
    const std::size_t parts = model.parts.size();
    out.components = Index(parts);
    out.mayMeet.assign(parts * parts, 1);
    if (pair.kind == ContactKind::general)
        for (std::size_t a = 0; a < parts; ++a)
            for (std::size_t b = 0; b < parts; ++b)
                if (model.parts[a].kind == PartKind::rigid
                    && model.parts[b].kind == PartKind::rigid)
                    out.mayMeet[a * parts + b] = 0;
    for (const auto& [a, b] : pair.apart)
        out.mayMeet[std::size_t(a) * parts + std::size_t(b)] =
            out.mayMeet[std::size_t(b) * parts + std::size_t(a)] = 0;
    const std::size_t bodies =
        std::set<Index>(out.faceComponent.begin(), out.faceComponent.end()).size();
    const std::vector<Index> nodes = out.contactor;
    for (std::size_t slot = 1; slot < std::min<std::size_t>(bodies, maxSlots); ++slot)
        out.contactor.insert(out.contactor.end(), nodes.begin(), nodes.end());
}

/// Faces that are no partner of a contactor of the same body: those of all elements at the nodes of
/// its own faces, so that neither its surroundings nor the other side of a thin layer capture it.
void addExclusions(PairData& out, const Model& model, const std::vector<ElementSide>& target)
{
    const Mesh& mesh = model.mesh;
    std::vector<std::vector<Index>> faces(mesh.hexahedra.size()), elements(mesh.points.size());
    for (std::size_t face = 0; face < target.size(); ++face)
        faces[std::size_t(target[face].element)].push_back(Index(face));
    for (std::size_t element = 0; element < mesh.hexahedra.size(); ++element)
        for (const Index node : mesh.hexahedra[element])
            elements[std::size_t(node)].push_back(Index(element));
    out.excludedStart.push_back(0);
    for (std::size_t i = 0; i < std::size_t(out.nodeCount); ++i) {
        std::set<Index> excluded;
        for (Index k = 4 * out.ownFaceStart[i]; k < 4 * out.ownFaceStart[i + 1]; ++k)
            for (const Index element : elements[std::size_t(out.ownFaceNode[std::size_t(k)])])
                excluded.insert(faces[std::size_t(element)].begin(),
                                faces[std::size_t(element)].end());
        out.excluded.insert(out.excluded.end(), excluded.begin(), excluded.end());
        out.excludedStart.push_back(Index(out.excluded.size()));
    }
}

/// One pass: the nodes of `own` against the faces of `target`, with a share of the stiffness.
PairData makePass(const Model& model,
                  const ContactPair& pair,
                  const std::vector<ElementSide>& own,
                  const std::vector<ElementSide>& target,
                  double share)
{
    PairData out;
    out.search = pair.search;
    out.friction = pair.friction;
    out.tangentialRatio = pair.tangentialScale / pair.normalScale;
    out.contactor = nodesOf(model.mesh, own);
    out.nodeCount = Index(out.contactor.size());
    out.forgives = pair.initialOverlap == InitialOverlap::offset
                   || pair.initialOverlap == InitialOverlap::ramp;
    out.fadeTime = pair.initialOverlap == InitialOverlap::ramp ? pair.rampTime : 0;
    addOwnFaces(out, model, own);

    // A rigid target has no stiffness of its own: it takes the mean of its partner's faces.
    double partner = 0, partners = 0;
    for (const ElementSide& side : own)
        if (!isRigid(model, side)) {
            partner += penalty(model, side);
            partners += 1;
        }
    double areas = 0;
    for (const ElementSide& side : target) {
        const Quad quad = model.mesh.sideNodes(side);
        out.faceNode.insert(out.faceNode.end(), quad.begin(), quad.end());
        const double a = area(model.mesh, side);
        areas += a;
        out.faceThickness.push_back(volume(model.mesh, side.element) / a);
        out.faceStiffness.push_back(
            share * pair.normalScale
            * (isRigid(model, side) ? partner / partners : penalty(model, side)));
    }
    out.meanFaceSize = std::sqrt(areas / double(target.size()));
    addTopology(out, model.mesh.points);
    if (pair.kind != ContactKind::pair) addExclusions(out, model, target);
    addComponents(out, model, pair, own, target);
    return out;
}

/// The passes of a pair: one, or two with half the stiffness each. A surface against itself has
/// each of its nodes against the other's faces and so half the stiffness too.
void addPasses(std::vector<PairData>& passes, const Model& model, std::size_t number)
{
    const ContactPair& pair = model.contactPairs[number];
    const std::vector<ElementSide>& own = ownSides(model, pair);
    const bool both = pair.passes == 2;
    passes.push_back(makePass(model, pair, own, pair.targetSides,
                              both || pair.kind != ContactKind::pair ? 0.5 : 1.0));
    passes.back().pair = number;
    if (!both) return;
    passes.push_back(makePass(model, pair, pair.targetSides, own, 0.5));
    passes.back().pair = number;
    passes.back().reversed = true;
}

/// False where every component of the node's motion is held or driven: no spring can disturb it.
bool movesFreely(const SolverData& data, std::size_t node)
{
    int imposed = data.fixed[node];
    if (!data.conditionStart.empty())
        for (Index k = data.conditionStart[node]; k < data.conditionStart[node + 1]; ++k) {
            const Condition& condition =
                data.conditions[std::size_t(data.conditionOf[std::size_t(k)])];
            if (condition.kind != 2) imposed |= condition.components;
        }
    return imposed != 7;
}

double powerOfTwoBelow(double value)
{
    return std::exp2(std::floor(std::log2(value)));
}

} // namespace

void addContact(SolverData& data, const Model& model)
{
    double largestForce = 0, largestStiffness = 0;
    std::size_t contactors = 0;
    for (std::size_t pair = 0; pair < model.contactPairs.size(); ++pair)
        addPasses(data.pairs, model, pair);
    for (const PairData& made : data.pairs) {
        contactors += made.contactor.size();
        for (std::size_t face = 0; face < made.faceStiffness.size(); ++face) {
            const double most =
                made.faceStiffness[face] * made.faceThickness[face] * (1 + made.friction);
            largestForce = std::max(largestForce, most);
            largestStiffness = std::max(largestStiffness, 2 * made.faceStiffness[face]);
        }
        data.contactNodes.insert(data.contactNodes.end(), made.contactor.begin(),
                                 made.contactor.end());
        data.contactNodes.insert(data.contactNodes.end(), made.target.begin(), made.target.end());
    }
    std::sort(data.contactNodes.begin(), data.contactNodes.end());
    data.contactNodes.erase(std::unique(data.contactNodes.begin(), data.contactNodes.end()),
                            data.contactNodes.end());
    data.contactNumber.assign(std::size_t(data.nodeCount), -1);
    for (std::size_t i = 0; i < data.contactNodes.size(); ++i) {
        const std::size_t node = std::size_t(data.contactNodes[i]);
        data.contactNumber[node] = Index(i);
        data.contactInverseMass.push_back(movesFreely(data, node) ? 1 / data.nodeMass[node] : 0);
    }
    for (PairData& pair : data.pairs) {
        for (const Index node : pair.contactor)
            pair.contactorNumber.push_back(data.contactNumber[std::size_t(node)]);
        for (const Index node : pair.faceNode)
            pair.faceNumber.push_back(data.contactNumber[std::size_t(node)]);
    }
    // Were every contactor on one node, with the largest force, the sum would stay below 2^62.
    const double room = std::exp2(61 - std::ceil(std::log2(double(contactors + 1))));
    data.contactScale.toFixed = powerOfTwoBelow(room / largestForce);
    data.contactScale.fromFixed = 1 / data.contactScale.toFixed;
    data.contactScale.toSpring = powerOfTwoBelow(room / largestStiffness);
    data.contactScale.fromSpring = 1 / data.contactScale.toSpring;
}

} // namespace fpm
