#pragma once

#include "mesh/Mesh.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace fpm {

enum class PartKind { elastic, elastoplastic, rigid };
/// How the rigid rotation of a step is taken out of an element.
enum class RotationForm { midSurface, arcsine, polar, hughesWinget };
enum class HourglassForm { stiffness, viscous, physical };
enum class HourglassPlastic { elastic, coupled }; ///< physical form when the section yields

struct Hardening {
    double equivalentPlasticStrain; ///< [-], ascending, first 0
    double yieldStress;             ///< [stress], last slope continues
};

/// constant/partProperties, one part.
struct Part {
    std::string name;
    PartKind kind = PartKind::elastic;
    double density = 0;       ///< [mass/length^3]
    double youngsModulus = 0; ///< [stress]
    double poissonsRatio = 0;
    RotationForm rotation = RotationForm::midSurface;
    std::vector<Hardening> hardening; ///< >= 1 row for elastoplastic; linear: two rows
    HourglassForm hourglass = HourglassForm::stiffness;
    double hourglassCoefficient = 0.05; ///< stiffness 0.05 | viscous 0.1 | physical 1
    HourglassPlastic hourglassPlastic = HourglassPlastic::coupled;
    double linearBulkViscosity = 0.06, quadraticBulkViscosity = 1.2;
};

/// A factor over time: constant 1, a table (linear between rows, held outside), or a smooth step
/// tau^3 (10 - 15 tau + 6 tau^2) from row to row (method of Abaqus' smooth amplitude).
struct Amplitude {
    enum class Kind { constant, table, smooth } kind = Kind::constant;
    std::vector<std::array<double, 2>> rows{{0.0, 1.0}}; ///< time, factor
    double operator()(double time) const;
    bool operator==(const Amplitude&) const = default;
};

/// constant/boundaryConditions, one entry, its set resolved to nodes.
struct BoundaryCondition {
    enum class Kind { fixed, displacement, velocity, force } kind = Kind::fixed;
    std::string name;
    std::vector<Index> nodes;                            ///< ascending
    std::array<bool, 3> constrains{false, false, false}; ///< components held or driven
    /// Displacement, velocity, or total force shared equally by the nodes.
    Point value{0, 0, 0};
    Amplitude amplitude;
};

/// 0/initialConditions, one entry.
struct InitialVelocity {
    std::string name;
    std::vector<Index> nodes;
    Point velocity;
};

enum class ContactSearch { faces, closestParticle };
/// Two surfaces; one against itself; all bodies against all, themselves included.
enum class ContactKind { pair, self, general };
/// What becomes of contactors that lie inside the target before the run: pushed out at the first
/// step, forgiven for good, forgiven for a while; `move` has moved them already.
enum class InitialOverlap { report, offset, ramp, move };

/// system/contactDict, one pair; surfaces as in the mesh.
struct ContactPair {
    std::string name;
    std::vector<Index> contactorNodes;
    std::vector<ElementSide> targetSides;
    double friction = 0;                           ///< Coulomb coefficient
    double normalScale = 1, tangentialScale = 0.1; ///< s_n, s_t: k = s K A^2 / V
    ContactSearch search = ContactSearch::faces;
    ContactKind kind = ContactKind::pair;
    int passes = 1; ///< 2: each side is contactor once, with half the stiffness
    InitialOverlap initialOverlap = InitialOverlap::report;
    double rampTime = 0; ///< over which `ramp` forgives
    /// Of general contact: parts that have pairs of their own.
    std::vector<std::array<Index, 2>> apart;
};

enum class Precision { double_, mixed, single };

/// A history of the run: controlDict, functions { ... }.
struct History {
    enum class Kind { energies, contactForces, point, reaction } kind = Kind::energies;
    std::string name;         ///< folder under postProcessing
    Index node = -1;          ///< point: nearest node of `part` to `position`
    std::vector<Index> nodes; ///< reaction: constrained nodes of a boundary condition
    std::vector<std::string> fields{"displacement"}; ///< point: displacement velocity acceleration
};

/// system/controlDict.
struct Control {
    double endTime = 0;
    double writeInterval = 0;      ///< time between frames
    double historyInterval = 0;    ///< time between history rows; 0 = every step
    double timeStepSafety = 0.9;   ///< of the stability bound
    double contactStepLimit = 0.5; ///< omega_c dt, the energy-quality bound
    double fixedTimeStep = 0;      ///< > 0: this step, checked against the bound
    double massDamping = 0;        ///< xi [1/time], eq. (3)
    double energyWarning = 0.01, energyStop = 0.05;
    std::string backend = "openmp"; ///< serial openmp cuda
    int threads = 0;                ///< 0 = all cores
    std::string simd = "auto";      ///< auto scalar avx2 avx512
    Precision precision = Precision::double_;
    bool midStepStrain = true; ///< strain at mid-step geometry; false: at its start (paper)
    std::vector<History> histories;
};

/// A validated case, complete and immutable: what the solver is built from.
struct Model {
    std::string title;
    std::array<std::string, 3> units{"mm", "tonne", "s"}; ///< length, mass, time
    Mesh mesh;
    std::vector<Part> parts; ///< as mesh.parts
    std::vector<BoundaryCondition> boundaryConditions;
    std::vector<InitialVelocity> initialVelocities;
    std::vector<ContactPair> contactPairs;
    Control control;
};

} // namespace fpm
