#pragma once

#include "mesh/Mesh.h"
#include "model/BoundaryCondition.h"
#include "model/ContactLaw.h"
#include "model/RigidSurface.h"

#include <array>
#include <string>
#include <vector>

namespace fpm {

/// Number of the material in the list Materials (kernels/material); it may hold more than the two
/// that are named here. Below 0 no elements are worked: the part moves as a whole.
enum class PartKind : int { rigidFree = -2, rigidPrescribed = -1, elastic = 0, elastoplastic = 1 };
constexpr bool isRigid(PartKind kind)
{
    return int(kind) < 0;
}
/// How the rigid rotation of a step is taken out of an element.
enum class RotationForm { midSurface, arcsine, polar, hughesWinget };
/// One integration point with hourglass control, or eight with the mean dilatation (B-bar).
enum class HexahedronForm { reduced, selective };
enum class HourglassForm { stiffness, viscous, physical };
/// Physical form when the section yields.
enum class HourglassPlastic { elastic, coupled };
/// How the hourglass state is kept between steps: in the working type, or as floats.
enum class HourglassStorage { full, float_ };
enum class RateDependence { none, cowperSymonds, johnsonCook };

inline constexpr std::size_t mostHardeningRows = 32; ///< of a part

struct Hardening {
    double equivalentPlasticStrain; ///< [-], ascending, first 0
    double yieldStress;             ///< [stress], last slope continues
};

/// Mass properties of a rigidFree part where they are given, not taken from mesh and density.
struct GivenInertia {
    double mass = 0; ///< 0: from the mesh
    bool hasCentre = false, hasInertia = false;
    Point centre{0, 0, 0};
    std::array<double, 6> inertia{}; ///< about the centre: xx yy zz xy yz zx, xy = -sum m x y
};

/// Yield stress beyond its hardening rows, and what becomes of plastic work; all off by default.
struct Flow {
    double kinematicModulus = 0;                ///< H_k, Prager's rule [stress]
    double powerModulus = 0, powerExponent = 0; ///< B, n of Johnson and Cook
    RateDependence rate = RateDependence::none;
    double referenceRate = 0;   ///< Cowper-Symonds D, Johnson-Cook rate0 [1/time]
    double rateCoefficient = 0; ///< 1/p, C
    double softeningExponent = 0, meltingTemperature = 0, roomTemperature = 293; ///< m of 1 - T*^m
    double heatFraction = 0, specificHeat = 0; ///< Taylor-Quinney; [energy/(mass temperature)]
    double temperature = 293;                  ///< at the start
    bool operator==(const Flow&) const = default;
};

/// When elements of a part are deleted.
struct ElementErosion {
    double plasticStrain = 0; ///< > 0: beyond this equivalent plastic strain
    bool inverted = false;    ///< when an element turns inside out
    bool any() const { return plasticStrain > 0 || inverted; }
};

/// constant/partProperties, one part.
struct Part {
    std::string name;
    PartKind kind = PartKind::elastic;
    double density = 0;       ///< [mass/length^3]
    double youngsModulus = 0; ///< [stress]
    double poissonsRatio = 0;
    HexahedronForm hexahedron = HexahedronForm::reduced;
    RotationForm rotation = RotationForm::midSurface; ///< selective: always hughesWinget
    std::vector<Hardening> hardening; ///< >= 1 row for elastoplastic; linear: two rows
    Flow flow;
    std::vector<double> lawValues; ///< parameters of the material, in its order (MaterialEntry)
    ElementErosion erosion;
    HourglassForm hourglass = HourglassForm::physical;
    double hourglassCoefficient = 1; ///< stiffness 0.05 | viscous 0.1 | physical 1
    HourglassPlastic hourglassPlastic = HourglassPlastic::coupled;
    HourglassStorage hourglassStorage = HourglassStorage::full;
    GivenInertia inertia; ///< rigidFree
    double linearBulkViscosity = 0.06, quadraticBulkViscosity = 1.2;
    double massFactor = 1; ///< mass scaling: of every element
    double targetStep = 0; ///< mass scaling: stable step no element stays below, 0: none [time]
};

enum class ContactSearch { faces, closestParticle };
/// How a contactor finds its place at a step: warm, on the face it follows; or cold, from the
/// middle of every face around the nearest corner.
enum class ContactProjection { tracked, cold };
/// Two surfaces; one against itself; all bodies against all, themselves included.
enum class ContactKind { pair, self, general };
/// Treatment of contactors that lie inside the target before the run: pushed out at the first step;
/// without force until they have separated, or for a while; `move` has moved them already. An
/// analytic surface always pushes them out.
enum class InitialOverlap { report, offset, ramp, move };

/// system/contactDict, one pair; surfaces as in the mesh.
struct ContactPair : ContactLaw {
    std::string name;
    std::vector<Index> contactorNodes;
    std::vector<ElementSide> targetSides; ///< empty where an analytic surface is the target
    Index surface = -1;                   ///< that surface, in Model::rigidSurfaces
    ContactSearch search = ContactSearch::faces;
    ContactProjection projection = ContactProjection::tracked;
    ContactKind kind = ContactKind::pair;
    int passes = 1;     ///< 2: each side is contactor once, with half the stiffness
    bool edges = false; ///< sharp edges meet each other too
    InitialOverlap initialOverlap = InitialOverlap::offset;
    double rampTime = 0; ///< over which `ramp` forgives
    /// Of general contact: parts that have pairs of their own.
    std::vector<std::array<Index, 2>> apart;

    bool hasSprings() const { return surface < 0 || enforcement == Enforcement::penalty; }
};

enum class Precision { double_, mixed, single };

/// Who moves the nodes that belong to one patch of elements alone: its kernel, or, as all others, a
/// pass over the nodes. Equal bits.
enum class Assembly { patch, gather };

/// A history of the run: controlDict, functions { ... }.
struct History {
    enum class Kind {
        energies,
        contactForces,
        point,
        reaction,
        rigidBody,
        part
    } kind = Kind::energies;
    std::string name;                   ///< folder under postProcessing
    Index node = -1;                    ///< point: nearest node of `part` to `position`
    std::vector<Index> nodes;           ///< reaction: constrained nodes of a boundary condition
    Index condition = -1, surface = -1; ///< reaction: of a boundary condition or analytic surface
    double factor = 1;                  ///< reaction: of the force, 4 for a quarter model
    Index part = -1;                    ///< rigidBody, part
    std::vector<std::string> fields{"displacement"}; ///< point: displacement velocity acceleration
};

/// Frames at multiples of simulated time, which end a step each; every so many steps; or every so
/// many seconds of the clock on the wall.
enum class WriteControl { runTime, timeStep, clockTime };
/// Where a run ends: at endTime; now, with or without a frame; at the next frame.
enum class StopAt { endTime, writeNow, noWriteNow, nextWrite };

/// When checkpoints are written beside that at the end.
struct CheckpointControl {
    double wallInterval = 600; ///< seconds between them; 0: none by the clock
    std::int64_t steps = 0;    ///< > 0: at every multiple of so many steps
    int keep = 2;              ///< files; 0: no checkpoints
    bool operator==(const CheckpointControl&) const = default;
};

/// system/controlDict.
struct Control {
    bool latest = false;  ///< start from the latest checkpoint, where there is one
    double startTime = 0; ///< > 0: from the checkpoint of this time
    StopAt stopAt = StopAt::endTime;
    double endTime = 0;
    double maxWallTime = 0; ///< > 0: seconds of the program after which it stores its state and
                            ///< ends
    WriteControl writeControl = WriteControl::runTime;
    double writeInterval = 0;       ///< between frames: time, steps or seconds
    int purgeWrite = 0;             ///< > 0: so many frames are kept, the latest
    bool runTimeModifiable = false; ///< controlDict is read again when it changes
    CheckpointControl checkpoint;
    double historyInterval = 0;     ///< time between history rows; 0 = every step
    double timeStepSafety = 0.9;    ///< of the stability bound
    double contactStepLimit = 0.8;  ///< omega_c dt, the energy-quality bound
    double maximumTimeStep = 0;     ///< > 0: no step is longer
    double fixedTimeStep = 0;       ///< > 0: this step, checked against the bound
    bool beyondBound = false;       ///< the fixed step may exceed it: to see what happens
    int searchInterval = 0;         ///< steps between contact searches; 0: while the lists last
    double massDamping = 0;         ///< xi [1/time], eq. (3)
    double kineticShare = 0;        ///< quasi-static: warn beyond this, 0: never
    double quasiStaticAfter = 0;    ///< start phase without that warning [time]
    double relaxationTolerance = 0; ///< > 0: dynamic relaxation to rest
    double energyWarning = 0.01, energyStop = 0.05;
    std::string backend = "openmp"; ///< serial openmp cuda
    int threads = 0;                ///< 0 = as many as cores are idle
    int device = 0;                 ///< number of the GPU
    std::string simd = "auto";      ///< auto scalar avx2 avx512
    Precision precision = Precision::double_;
    Assembly assembly = Assembly::patch;
    bool paperAlgorithm = false;      ///< that of the paper as a whole, for comparison
    bool midStepStrain = true;        ///< strain at mid-step geometry; false: at its start (paper)
    std::string previousRun = "keep"; ///< what an earlier run left: keep remove refuse
    std::vector<History> histories;
};

/// A validated case, complete and immutable: what the solver is built from.
struct Model {
    std::string title;
    std::array<std::string, 3> units{"mm", "tonne", "s"}; ///< length, mass, time
    Mesh mesh;
    std::vector<Part> parts; ///< as mesh.parts
    std::vector<BoundaryCondition> boundaryConditions;
    std::vector<InitialVelocity> initialVelocities; ///< they add up
    std::vector<RigidSurface> rigidSurfaces;        ///< system/contactDict, surfaces with a type
    std::vector<ContactPair> contactPairs;
    Control control;
};

} // namespace fpm
