#pragma once

namespace fpm {

/// Beyond which a figure of a run is a finding. Those of the energy balance and of the kinetic
/// share of slow runs are the case's own (controlDict).
struct HealthLimits {
    /// Energy of spurious modes over the internal energy of a part. Users of elements with one
    /// point hold 5 to 10 % for the most that a result can bear.
    static constexpr double hourglass = 0.1;
    /// Contact springs over internal energy when both hold most: the springs stand for nothing
    /// real. With normalScale 1 they are as soft as one or two elements, so that bodies of few
    /// elements hold a tenth in them; from a fifth on, force and displacement are less accurate
    /// than such elements alone allow.
    static constexpr double contactSprings = 0.2;
    /// Penetration over the width of a face: from a quarter on, which is the reach of a search, a
    /// contactor is as far inside as it may be outside and still be tracked.
    static constexpr double depthOfFace = 0.25;
    /// Penetration over the thickness of the target: beyond the whole it is released.
    static constexpr double depthOfThickness = 0.5;
    /// Depth of an edge in the other surface, between its nodes, over the width of a face. The
    /// chords of an octagon are up to a tenth of their length inside the circle through its
    /// corners: less is the error of a meshed round rim.
    static constexpr double depthOfEdge = 0.1;
    /// Friction delivered over that of Coulomb while a pair slides: smooth sliding reaches 0.99.
    static constexpr double friction = 0.95;
    /// Mass added by scaling over the body's own where the inertia is not monitored.
    static constexpr double addedMass = 0.05;
    /// Rigid motion over all kinetic energy of a body that should come to rest or move slowly: with
    /// supports it is a part, without it is nearly all.
    static constexpr double rigidMotion = 0.9;
    /// Energies below this share of the run's largest are not worth a verdict.
    static constexpr double counts = 0.01;
};

} // namespace fpm
