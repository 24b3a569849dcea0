#include "base/Error.h"
#include "base/Format.h"
#include "mesh/Quality.h"
#include "mesh/Surface.h"
#include "solver/PenaltyData.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fpm {

namespace {

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

/// Face across each edge; -1 where the surface ends, or where more than two faces meet.
void addNeighbours(PairData& out)
{
    std::map<std::pair<Index, Index>, std::vector<std::size_t>> edges;
    const auto key = [&](std::size_t face, std::size_t edge) -> std::pair<Index, Index> {
        const Index a = out.faceNode[4 * face + edge], b = out.faceNode[4 * face + (edge + 1) % 4];
        return std::minmax(a, b); // copied: minmax itself returns references
    };
    const std::size_t faces = out.faceNode.size() / 4;
    for (std::size_t face = 0; face < faces; ++face)
        for (std::size_t edge = 0; edge < 4; ++edge) edges[key(face, edge)].push_back(face);
    out.neighbour.assign(4 * faces, -1);
    for (std::size_t face = 0; face < faces; ++face)
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const auto& both = edges[key(face, edge)];
            if (both.size() == 2)
                out.neighbour[4 * face + edge] = Index(both[0] == face ? both[1] : both[0]);
        }
}

void addTargetNodes(PairData& out)
{
    out.target = out.faceNode;
    std::sort(out.target.begin(), out.target.end());
    out.target.erase(std::unique(out.target.begin(), out.target.end()), out.target.end());
    std::map<Index, std::vector<Index>> faces;
    for (std::size_t i = 0; i < out.faceNode.size(); ++i)
        faces[out.faceNode[i]].push_back(Index(i / 4));
    out.targetFaceStart.push_back(0);
    for (const Index node : out.target) {
        out.targetFaces.insert(out.targetFaces.end(), faces[node].begin(), faces[node].end());
        out.targetFaceStart.push_back(Index(out.targetFaces.size()));
    }
}

/// Largest distance between two corners of a target face.
double faceDiagonal(const PairData& pair, const Mesh& mesh)
{
    double diagonal = 0;
    for (std::size_t face = 0; face < pair.faceNode.size() / 4; ++face)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a + 1; b < 4; ++b) {
                double square = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double d = mesh.points[std::size_t(pair.faceNode[4 * face + a])][c]
                                     - mesh.points[std::size_t(pair.faceNode[4 * face + b])][c];
                    square += d * d;
                }
                diagonal = std::max(diagonal, std::sqrt(square));
            }
    return diagonal;
}

PairData makePair(const SolverData& data, const Model& model, const ContactPair& pair)
{
    const std::vector<ElementSide>& own = ownSides(model, pair);
    if (pair.surface >= 0) return makeSurfacePair(data, model, pair, own);
    PairData out;
    out.name = pair.name;
    out.search = pair.search;
    out.law = pair;
    out.contactor = pair.contactorNodes;
    addOwnFaces(out, model, own);
    double areas = 0;
    for (const ElementSide& side : pair.targetSides) {
        const Quad quad = model.mesh.sideNodes(side);
        out.faceNode.insert(out.faceNode.end(), quad.begin(), quad.end());
        const double a = area(model.mesh, side);
        areas += a;
        out.faceThickness.push_back(volume(model.mesh, side.element) / a);
    }
    addPenalty(out, data, model, pair, own);
    out.meanFaceSize = std::sqrt(areas / double(pair.targetSides.size()));
    addNeighbours(out);
    addTargetNodes(out);

    const double diagonal = faceDiagonal(out, model.mesh);
    out.reach = 0.25 * out.meanFaceSize;
    const double thickest = *std::max_element(out.faceThickness.begin(), out.faceThickness.end());
    // However a face turns, its box is no larger than its diagonal; it may stretch by half.
    out.cellSize = out.search == ContactSearch::faces
                       ? 1.5 * diagonal + 2 * std::max(out.reach, thickest / 2)
                       : std::max(out.meanFaceSize, diagonal / std::sqrt(3.0) + out.reach);
    return out;
}

double powerOfTwoBelow(double value)
{
    return std::exp2(std::floor(std::log2(value)));
}

} // namespace

void addContact(SolverData& data, const Model& model)
{
    for (const RigidSurface& surface : model.rigidSurfaces)
        data.surfaces.push_back(surfaceShape(surface, data.amplitudeRows));
    double largestForce = 0, largestStiffness = 0;
    std::size_t contactors = 0;
    for (const ContactPair& pair : model.contactPairs) {
        data.pairs.push_back(makePair(data, model, pair));
        const PairData& made = data.pairs.back();
        contactors += made.contactor.size();
        const double stiffness = fpm::largestStiffness(made);
        double depth = made.deepest;
        for (const double thickness : made.faceThickness) depth = std::max(depth, thickness);
        // Damping at the speed that crosses the depth in one step, omega dt down to 2e-3 zeta.
        const double most = 1 + made.law.friction + (made.law.normalDamping > 0 ? 1e3 : 0);
        largestForce = std::max(largestForce, stiffness * depth * most);
        largestStiffness = std::max(largestStiffness, 2 * stiffness * dampingLimit(made.law));
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
