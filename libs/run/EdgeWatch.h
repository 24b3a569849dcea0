#pragma once

#include "base/Archive.h"
#include "base/Log.h"
#include "model/EdgeCrossing.h"
#include "solver/Solver.h"
#include "solver/contact/MirrorPlanes.h"

#include <map>

namespace fpm {

/// Edges of one surface that pass through another between their nodes.
struct EdgeFinding {
    std::string pair; ///< "pair wires", "pair general, parts a and b"
    EdgeCrossings crossings;
    double time = 0;
    bool springs = false; ///< the pair has contact of edges

    bool isDeep() const;
    std::string advice() const;
};

/// Watches for edges that contact does not hold, between the surfaces of pairs and the
/// bodies of general contact, which warn once each where edges are deep.
class EdgeWatch
{
public:
    explicit EdgeWatch(const Model& model);
    EdgeWatch(const EdgeWatch&) = delete;
    EdgeWatch& operator=(const EdgeWatch&) = delete;
    /// Checks now, at a history row: often enough to see bodies pass, and so seldom that it costs
    /// less than a hundredth of the run or a tenth of a second.
    void checkIfDue(Solver& solver, Log& log);
    void check(Solver& solver, Log& log);
    std::vector<EdgeFinding> findings() const;
    void keep(Archive& archive);

private:
    /// Surfaces that may meet: the two of a pair, or the bodies of general contact.
    struct Group {
        const ContactPair* pair;
        std::vector<std::vector<ElementSide>> surfaces;
        std::vector<Index> parts; ///< of general contact, as surfaces
        std::map<std::pair<std::size_t, std::size_t>, EdgeFinding> found; ///< the deepest
    };
    void add(const ContactPair& pair, const ContactSurfaces& surfaces);
    bool mayMeet(const Group& group, std::size_t a, std::size_t b) const;
    std::string name(const Group& group, std::size_t a, std::size_t b) const;
    double interval(const StepClock& clock) const;

    const Model& model_;
    std::vector<Group> groups_;
    std::vector<MirrorPlane> planes_;
    std::vector<SurfaceMirror> mirrors_; ///< of the planes
    std::size_t sides_ = 0;
    double next_ = 0; ///< time of the next check
};

} // namespace fpm
