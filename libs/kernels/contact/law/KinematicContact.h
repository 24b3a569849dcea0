#pragma once

#include "kernels/contact/law/Friction.h"
#include "kernels/contact/law/StepGap.h"

namespace fpm {

/// A pass whose surface is met exactly. Arrays over its contactors.
struct KinematicPass {
    Index count;
    SurfaceShape shape;
    FrictionLaw<double> friction;
    double push;        ///< farthest that a contactor inside comes out in one step
    double* dissipated; ///< by friction, running sum; null without friction
    double* impact;     ///< kinetic energy lost in the normal direction, running sum
    double* work;       ///< done by the surface, running sum
    double* reading;    ///< [surfaceReadings][count]
};

/// What is read of a contactor of a KinematicPass at the time of the positions: the force on it,
/// and the half works of that force that the running sums do not contain yet.
enum SurfaceReading {
    readForce,
    readDissipated = readForce + 3,
    readImpact,
    readWork,
    surfaceReadings
};

/// What becomes of the works of a correction.
enum class SurfaceBooks {
    none,
    running, ///< they are booked for good
    reading, ///< written as a reading: the step is one that may follow
};

/// A node as the contactor of a KinematicPass.
struct SurfaceUse {
    Index pass, contactor;
};

/// Directions in which a node can move: all but its fixed and prescribed ones.
struct FreeDirections {
    bool all;
    Mat3<double> projection;

    FPM_KERNEL Vec3<double> of(const Vec3<double>& v) const { return all ? v : projection * v; }
};

/// A step of a node, from its place at time `start`.
struct SurfaceStep {
    Vec3<double> place;
    Vec3<double> velocity;  ///< of the step before, of length `previous`
    Vec3<double> increment; ///< displacement in this step as all other forces have it
    double start, previous, length;
    double mean;      ///< of the two lengths; half the length where this is the first step
    double stiffness; ///< force that changes the displacement by one unit: m / (dt h), h the mean
                      ///< of the two steps
    FreeDirections free;
};

/// Contact with analytic surfaces enforced exactly, as a predictor and corrector of the leapfrog: a
/// node whose predicted place is inside gets the force that puts it on the surface. The normals are
/// those at the start of the step, as in SHAKE (Ryckaert, Ciccotti and Berendsen 1977), so that
/// sliding over a round surface does no work. Coulomb friction is projected likewise: the force
/// that leaves no slip, or mu times the normal one. Of several surfaces those bear that press
/// (Moreau 1988: all gaps >= 0, all forces >= 0), at most three at once.
struct KinematicContact {
    static constexpr int most = 4; ///< surfaces that a node may meet in one step

    const Index* start; ///< uses of a node: CSR; null: no pass is kinematic
    const SurfaceUse* uses;
    const KinematicPass* passes;
    const double* amplitudeRows;

    FPM_KERNEL bool acts(std::size_t node) const { return start && start[node + 1] > start[node]; }

    /// Corrects the increment; returns the force of the surfaces.
    FPM_KERNEL Vec3<double> correct(std::size_t node, SurfaceStep& step, SurfaceBooks books) const
    {
        Contacts contacts;
        contacts.free = &step.free;
        contacts.predicted = step.increment;
        contacts.increment = step.increment;
        // What presses is found by what it pushes the node into, in the order of the passes.
        for (int found = 0; found <= most; ++found) {
            const int before = contacts.count;
            for (Index k = start[node]; k < start[node + 1]; ++k)
                meet(k, step, found > 0, contacts);
            if (contacts.count == before) break;
            contacts.solve();
            for (int sweep = 0; sweep < 20 && contacts.slide(); ++sweep) contacts.solve();
        }
        step.increment = contacts.increment;
        Vec3<double> force{0, 0, 0};
        for (int i = 0; i < contacts.count; ++i) force += book(contacts.one[i], step, books);
        return force;
    }

private:
    /// A surface that a node meets in a step. Impulses are the displacements they cause in a node
    /// that is free.
    struct Contact {
        StepGap surface;
        Vec3<double> direction;  ///< of the normal impulse
        Vec3<double> answer;     ///< displacement by a unit of it
        Vec3<double> moves;      ///< displacement of the surface in this step,
        Vec3<double> velocity;   ///< and its velocity in the one before
        Vec3<double> tangential; ///< impulse of friction
        double normal;           ///< impulse
        double coefficient;      ///< of friction
        Index use;
    };

    struct Contacts {
        Contact one[most];
        int count = 0;
        const FreeDirections* free;
        Vec3<double> predicted, increment;

        /// Normal impulses that leave no node inside: the first set of surfaces, the smallest sets
        /// first, whose impulses press and that opens no other one.
        FPM_KERNEL void solve()
        {
            Vec3<double> start = predicted;
            for (int i = 0; i < count; ++i) start += free->of(one[i].tangential);
            constexpr unsigned sets[] = {0, 1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 7, 11, 13, 14};
            double best[most] = {}, least = 1e300;
            Vec3<double> place = start;
            for (const unsigned set : sets) {
                if (set >> count) continue;
                double impulse[most] = {};
                Vec3<double> u = start;
                if (!press(set, impulse, u)) continue;
                double violation = 0;
                for (int i = 0; i < count; ++i) {
                    const double depth = one[i].surface.depthAfter(u - one[i].moves);
                    if (depth > violation) violation = depth;
                }
                if (!(violation < least)) continue;
                least = violation;
                place = u;
                for (int i = 0; i < most; ++i) best[i] = impulse[i];
                if (violation <= tolerance()) break;
            }
            increment = place;
            for (int i = 0; i < count; ++i) one[i].normal = best[i];
        }

        /// One sweep of friction; false where nothing changes any more.
        FPM_KERNEL bool slide()
        {
            bool changed = false;
            for (int i = 0; i < count; ++i) {
                Contact& c = one[i];
                if (!(c.coefficient > 0)) continue;
                const Vec3<double> slip = inPlane(increment - c.moves, c.direction),
                                   old = c.tangential;
                const double bound = c.coefficient * c.normal;
                const bool first = !(dot(old, old) > 0);
                // Where it cannot follow, slip does not tell how much friction there may be.
                const double rate = first && !free->all && dot(slip, slip) > 0
                                        ? bound / squareRoot(dot(slip, slip))
                                        : 1;
                Vec3<double> trial = old - rate * slip;
                const double size = squareRoot(dot(trial, trial));
                if (size > bound) trial = (bound / size) * trial;
                const Vec3<double> change = trial - old;
                c.tangential = trial;
                increment += free->of(change);
                changed |= squareRoot(dot(change, change)) > tolerance();
            }
            return changed;
        }

        FPM_KERNEL double tolerance() const
        {
            double sum = 0;
            for (int i = 0; i < count; ++i)
                if (one[i].surface.rounding > sum) sum = one[i].surface.rounding;
            return sum;
        }

    private:
        /// Newton's method for the impulses of a set; on planes its first step is exact. False
        /// where they would pull, or the surfaces depend on each other.
        FPM_KERNEL bool press(unsigned set, double (&impulse)[most], Vec3<double>& u) const
        {
            int member[3], size = 0;
            for (int i = 0; i < count; ++i)
                if (set >> i & 1) member[size++] = i;
            const Vec3<double> start = u;
            for (int iteration = 0; iteration < 12 && size > 0; ++iteration) {
                double matrix[3][3], depth[3], worst = 0;
                for (int i = 0; i < size; ++i) {
                    const Contact& c = one[member[i]];
                    const Vec3<double> relative = u - c.moves, n = c.surface.normalAfter(relative);
                    depth[i] = c.surface.depthAfter(relative);
                    const double size_ = depth[i] < 0 ? -depth[i] : depth[i];
                    if (size_ > worst) worst = size_;
                    for (int j = 0; j < size; ++j) matrix[i][j] = dot(n, one[member[j]].answer);
                }
                if (iteration > 0 && worst <= 0.25 * tolerance()) break;
                if (!solved(size, matrix, depth)) return false;
                u = start;
                for (int i = 0; i < size; ++i) {
                    impulse[member[i]] += depth[i];
                    u += impulse[member[i]] * one[member[i]].answer;
                }
            }
            for (int i = 0; i < size; ++i)
                if (!(impulse[member[i]] >= 0)) return false;
            return true;
        }

        /// Gaussian elimination without pivots, of a matrix that is nearly symmetric and positive.
        FPM_KERNEL static bool solved(int size, double (&a)[3][3], double (&b)[3])
        {
            for (int k = 0; k < size; ++k) {
                if (!(a[k][k] > 1e-8)) return false;
                for (int i = k + 1; i < size; ++i) {
                    const double factor = a[i][k] / a[k][k];
                    for (int j = k; j < size; ++j) a[i][j] -= factor * a[k][j];
                    b[i] -= factor * b[k];
                }
            }
            for (int k = size - 1; k >= 0; --k) {
                for (int j = k + 1; j < size; ++j) b[k] -= a[k][j] * b[j];
                b[k] /= a[k][k];
            }
            return true;
        }
    };

    /// Adds the surface of a use if the node would be inside it.
    FPM_KERNEL void
    meet(Index use, const SurfaceStep& step, bool corrected, Contacts& contacts) const
    {
        for (int i = 0; i < contacts.count; ++i)
            if (contacts.one[i].use == use) return;
        if (contacts.count == most) return;
        const KinematicPass& pass = passes[uses[use].pass];
        const double end = step.start + step.length;
        const Vec3<double> now = pass.shape.displacement(amplitudeRows, step.start),
                           moves = pass.shape.displacement(amplitudeRows, end) - now,
                           u = contacts.increment - moves;
        StepGap surface(pass.shape, step.place - now, pass.push);
        if (!surface.opposite(u)) return;
        // What a correction leaves within rounding is no contact.
        if (!(surface.depthAfter(u) > (corrected ? surface.rounding : 0))) return;
        Contact& c = contacts.one[contacts.count];
        const Vec3<double> after = surface.normalAfter(u);
        // A node that comes from beside or behind is pushed where it arrives.
        c.direction = dot(surface.normal, after) > 0.5 ? surface.normal : after;
        c.answer = step.free.of(c.direction);
        if (!(dot(c.direction, c.answer) > 1e-4)) return; // it cannot follow
        c.surface = surface;
        c.moves = moves;
        c.velocity =
            step.previous > 0
                ? (1 / step.previous)
                      * (now - pass.shape.displacement(amplitudeRows, step.start - step.previous))
                : (1 / step.length) * moves;
        c.tangential = {0, 0, 0};
        c.normal = 0;
        const Vec3<double> slip = inPlane(step.velocity - c.velocity, c.direction);
        c.coefficient = pass.friction.coefficient(squareRoot(dot(slip, slip)), 1);
        c.use = use;
        ++contacts.count;
    }

    /// Books the works of a contact, h F . (v^- + v^+) / 2, so that their sum is the change of
    /// kinetic energy whatever the steps are; the first half of it where it is read. Returns the
    /// force.
    FPM_KERNEL Vec3<double>
    book(const Contact& c, const SurfaceStep& step, SurfaceBooks books) const
    {
        const Vec3<double> press = (step.stiffness * c.normal) * c.direction,
                           friction = step.stiffness * c.tangential, force = press + friction;
        if (books == SurfaceBooks::none) return force;
        const SurfaceUse use = uses[c.use];
        const KinematicPass& pass = passes[use.pass];
        const bool read = books == SurfaceBooks::reading;
        const double half = 0.5 * step.mean, next = half / step.length;
        Vec3<double> surface = half * c.velocity, slip = half * (step.velocity - c.velocity);
        if (!read) {
            surface += next * c.moves;
            slip += next * (step.increment - c.moves);
        }
        double work = dot(force, surface), lost = -dot(press, slip);
        if (c.surface.inside) { // it is pushed out: that is work, no impact
            work -= lost;
            lost = 0;
        }
        const double frictional = -dot(friction, slip);
        if (read) {
            const double all[surfaceReadings] = {force.x, force.y, force.z, frictional, lost, work};
            for (int k = 0; k < surfaceReadings; ++k)
                pass.reading[std::size_t(k) * std::size_t(pass.count)
                             + std::size_t(use.contactor)] = all[k];
            return force;
        }
        pass.impact[use.contactor] += lost;
        pass.work[use.contactor] += work;
        if (pass.dissipated) pass.dissipated[use.contactor] += frictional;
        return force;
    }
};

} // namespace fpm
