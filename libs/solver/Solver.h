#pragma once

#include "kernels/particle/NodeSample.h"
#include "kernels/particle/StepClock.h"
#include "model/Model.h"
#include "solver/SolverData.h"
#include "solver/StateValues.h"

#include <functional>
#include <memory>

namespace fpm {

/// What the elements of one part hold and have dissipated; see Energies.
struct PartEnergies {
    double internal = 0, plastic = 0, hourglass = 0;
};

/// The ledger at one time: work and energy in the case's units.
struct Energies {
    double time = 0;
    double kinetic = 0;
    double internal = 0;  ///< elastic and plastic work of the elements; that of their bending too,
                          ///< where the form of hourglass control is `physical`
    double plastic = 0;   ///< of internal: plastic work
    double hourglass = 0; ///< of spurious modes
    double bulkViscosity = 0;
    std::vector<PartEnergies> parts; ///< as Model::parts
    double contact = 0; ///< in the penalty springs, recoverable but for those of deleted faces
    double friction = 0, contactDamping = 0, damping = 0;
    double external = 0; ///< done by loads, drives and moving surfaces
    double total = 0;    ///< everything held or dissipated
    /// Kinetic over what elements hold and have dissipated: how much inertia there is in a slow
    /// run.
    double kineticShare() const
    {
        return internal + hourglass > 0 ? kinetic / (internal + hourglass) : 0;
    }
    double error = 0;   ///< total - external - start
    double scale = 0;   ///< largest so far of kinetic, internal, external, lost to friction and
                        ///< damping, start, and of what rounding explains: see roundingEnergy
    double balance = 0; ///< error / scale
};

/// Works done on the nodes up to a time, trapezoidal: what the exact discrete identity sums.
struct NodalWorks {
    double internal = 0, contact = 0, external = 0, drives = 0, damping = 0;
};

/// All passes of a pair together; of a surface in contact with itself, and of general contact, the
/// forces on all nodes as contactors.
struct PairForce {
    Point force{0, 0, 0}; ///< on the contactor
    Index active = 0;     ///< contactors in touch, of both sides where both are
    /// Since the start: contactors let go because they went too deep, and that left over a free
    /// edge; searches that found a contactor inside, another face nearer than the one followed, and
    /// more bodies in reach of a node than it can touch; lists used for longer than they lasted.
    std::int64_t released = 0, overEdge = 0, inside = 0, mistaken = 0, crowded = 0, late = 0;
    double spring = 0;                ///< recoverable energy of its springs
    double friction = 0, damping = 0; ///< dissipated since the start
};

/// How the contactors of a pair that are in touch stand to their targets, over all its passes.
struct PairTouch {
    Index active = 0;
    /// Of those in touch, forgiven overlaps included; of means a contactor on a plane of symmetry
    /// counts half.
    double maxDepth = 0, meanDepth = 0;
    Index deepest = -1;      ///< node
    double thickness = 0;    ///< of the target at that node; 0: it has none
    double normal = 0;       ///< sum of the forces of the normal springs
    Point friction{0, 0, 0}; ///< on the contactor, as slip with pairs of two surfaces
    Point slip{0, 0, 0};     ///< mean velocity of contactors against the target, along it
    double speed = 0;        ///< mean length of that velocity
};

/// The node, or the part that is a free rigid body, whose contact springs are the stiffest for its
/// mass; -1: none.
struct ContactBound {
    Index node = -1, part = -1;
    double frequency = 0; ///< omega_c
};

/// Contactors of a pair that lie inside the target before the run.
struct PairOverlap {
    Index count = 0;
    double deepest = 0;
    Index node = -1; ///< the deepest
};

/// A rigid body at one time, in global axes.
struct BodyMotionValues {
    Point displacement, velocity, spin; ///< of the centre; angular velocity [rad/time]
    Point localSpin;                    ///< in axes that turn with the body, global at the start
    Point force, moment;                ///< of contact and loads, about the centre
    Point momentum;                     ///< angular, about the centre
    double kinetic = 0, halfStepKinetic = 0; ///< the latter at v^(n-1/2)
};

/// Seconds spent. On a GPU the parts are scaled up from a sample of the steps; 0 before the first.
struct StepTimes {
    double total = 0, element = 0, contact = 0, node = 0, search = 0;
    std::int64_t searches = 0; ///< of single passes
    double threads = 0;        ///< of the CPU, on average; 0 on a GPU
};

/// State of chosen nodes: [value][node], values as in NodeSample.
struct NodeValues {
    std::vector<double> values;
    std::size_t count = 0;
    Point at(int quantity, std::size_t i) const
    {
        const std::size_t q = std::size_t(3 * quantity);
        return {values[q * count + i], values[(q + 1) * count + i], values[(q + 2) * count + i]};
    }
};

struct ElementValues {
    std::vector<double> stress;        ///< [element][6], XX YY ZZ XY YZ XZ
    std::vector<double> plasticStrain; ///< [element]
    std::vector<bool> deleted;         ///< [element]
    std::vector<double> eroded;        ///< [element], elastic energy at its deletion
    std::vector<double> temperature;   ///< [element]; empty where no part heats
};

/// A model in motion. One abstract door; behind it everything is compiled for one precision and one
/// executor. All times are exact: forces, stress and positions belong to clock().time.
class Solver
{
public:
    virtual ~Solver() = default;

    /// Forces at the start, without motion. Called once, before the first advance().
    virtual void start() = 0;
    /// Steps until `time` is reached exactly or `maxSteps` are done. Stops early only on failure.
    virtual void advance(double time, std::int64_t maxSteps) = 0;
    /// Goes on with so many threads of the CPU, those it was made with at most. No bit depends on
    /// it.
    virtual void useThreads(int threads) = 0;
    /// advance() calls `observer` every few steps, between two of them; empty: nobody. What it does
    /// must not touch the solver.
    virtual void watch(std::function<void(const StepClock&)> observer) = 0;

    virtual StepClock clock() const = 0;
    virtual Energies energies() = 0;
    virtual NodalWorks nodalWorks() = 0;
    virtual PairForce pairForce(std::size_t pair) = 0;
    virtual PairTouch pairTouch(std::size_t pair) = 0;
    virtual BodyMotionValues bodyMotion(std::size_t body) = 0; ///< as SolverData::body
    virtual ContactBound contactLimit() = 0;
    virtual PairOverlap initialOverlap(std::size_t pair) const = 0;     ///< known after start()
    virtual NodeValues nodeValues(const std::vector<Index>& nodes) = 0; ///< all nodes when empty
    virtual ElementValues elementValues() = 0;
    virtual StateValues elementState() = 0;
    /// Of each node that is a contactor with a target within reach: the distance to it, negative
    /// inside, the least where it has several; NaN of all others. Overlaps that are forgiven count.
    virtual std::vector<double> contactGaps() = 0;
    /// FNV-1a over positions, velocities, stress, plastic strain, hourglass forces, friction.
    virtual std::uint64_t stateChecksum() = 0;
    virtual StepTimes times() const = 0;
    virtual std::size_t deviceBytes() const = 0;
    virtual std::string description() const = 0; ///< "openmp, 2 threads, avx512, double"
    virtual const SolverData& data() const = 0;
};

/// Builds the solver for the model's backend, vector width and precision. Throws Error(device) when
/// the backend is not in this build or the machine lacks it; never falls back silently.
/// `audit`: book nodal works of every force family, for tests.
std::unique_ptr<Solver> makeSolver(const Model& model, bool audit = false);
/// Threads of the CPU that a run has at most: as many as it may use cores, or OMP_NUM_THREADS,
/// where openmp has no other instruction. Without both it follows the cores that are idle
/// (IdleCores).
int threadCount(const Control& control);

} // namespace fpm
