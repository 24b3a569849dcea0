#pragma once

#include "base/Types.h"
#include "kernels/contact/narrow/FaceProjection.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// Coulomb friction with elastic slip: mu = mu_d + (mu_s - mu_d) exp(-decay |slip rate|).
template <class Work>
struct FrictionLaw {
    Work staticCoefficient, dynamicCoefficient;
    double decay;        ///< [time/length]
    Work stiffnessRatio; ///< k_t / k_n
    bool paper;          ///< eqs. (17) and (18) as printed: the traction is a vector in fixed axes

    FPM_KERNEL bool acts() const { return staticCoefficient > 0; }
    FPM_KERNEL Work coefficient(Work slip, double step) const
    {
        if (!(staticCoefficient > dynamicCoefficient)) return staticCoefficient;
        const double speed = step > 0 ? double(slip) / step : 0;
        return dynamicCoefficient
               + (staticCoefficient - dynamicCoefficient) * Work(exponential(-decay * speed));
    }
};

/// Resistance of a sliding contactor to fluctuations of its slip rate. Steady sliding of an elastic
/// body with Coulomb's friction is unstable (Adams 1995; Martins, Guimaraes and Faria 1995): waves
/// of a few elements grow until contactors stick by turns, and the mean friction falls below mu
/// times the mean normal force. An instantaneous resistance to faster slip, whose mean is zero,
/// makes it stable (Rice, Lapusta and Ranjith 2001). Its force 2 zeta sqrt(k m) (v - v') acts along
/// the slip, v' the slip rate averaged over `memory` sqrt(m / k); changes within `steady` of v',
/// such as those of a body that brakes, are free of it.
template <class Work>
struct SlipDamping {
    Work ratio; ///< zeta
    Work* mean; ///< v' of each contactor; 0: not known; null: no such damping

    static constexpr double memory = 0.3, steady = 1e-3;
    static constexpr double stable = 0.7; ///< most of m / dt: the rate of the last step resists

    FPM_KERNEL bool acts() const { return mean != nullptr; }
    FPM_KERNEL void forget(Index i) const
    {
        if (acts()) mean[i] = 0;
    }
    /// Another slot goes on with the same slip.
    FPM_KERNEL void handOver(Index from, Index to) const
    {
        if (!acts()) return;
        mean[to] = mean[from];
        mean[from] = 0;
    }
    /// Force beside mu N; the mean follows.
    FPM_KERNEL Work resistance(Index i, Work slip, Work stiffness, Work mass, double step) const
    {
        if (!acts() || !(step > 0) || !(mass > 0) || !(stiffness > 0)) return Work(0);
        const Work period = squareRoot(mass / stiffness), rate = slip / Work(step), was = mean[i];
        const Work span = Work(memory) * period, change = was > 0 ? rate - was : Work(0);
        const bool follows = !(was > 0) || !(span > Work(step));
        mean[i] = follows ? rate : was + Work(step) / span * change;
        const Work free = Work(steady) * was, size = change < 0 ? -change : change;
        if (!(size > free)) return Work(0);
        const Work excess = change < 0 ? free - size : size - free;
        const Work factor = Work(2) * ratio * stiffness * period,
                   most = Work(stable) * mass / Work(step);
        return (factor < most ? factor : most) * excess;
    }
};

/// Return mapping of friction, eqs. (17) and (18) of the paper: the trial traction is the stored
/// one minus k_t times the slip increment (stick); beyond mu times the normal force plus the
/// `resistance`, between none and twice the former, it is scaled back to that bound (slip). The
/// work of the plastic slip is added to `dissipated`.
template <class Work>
FPM_KERNEL Vec3<Work> frictionForce(const FrictionLaw<Work>& law,
                                    const Vec3<Work>& stored,
                                    const Vec3<Work>& slip,
                                    Work tangentialStiffness,
                                    Work normalForce,
                                    double step,
                                    double& dissipated,
                                    Work resistance = Work(0))
{
    const Vec3<Work> trial = stored - tangentialStiffness * slip;
    const Work coulomb = law.coefficient(squareRoot(dot(slip, slip)), step) * normalForce;
    const Work less = resistance < -coulomb ? -coulomb : resistance,
               most = coulomb + (less < coulomb ? less : coulomb);
    const Work size = squareRoot(dot(trial, trial));
    if (!(size > most)) return trial;
    const Vec3<Work> capped = (most / size) * trial;
    // Mean force of the step times the plastic slip: then the work on the nodes, trapezoidal too,
    // equals stored plus dissipated energy.
    dissipated += double(Work(0.5) * dot(stored + capped, trial - capped) / tangentialStiffness);
    return capped;
}

template <class Work>
FPM_KERNEL Vec3<Work> inPlane(const Vec3<Work>& v, const Vec3<Work>& normal)
{
    return v - dot(v, normal) * normal;
}

/// Vector of the plane with normal `from`, rotated into the plane with normal `to` by the smallest
/// rotation; its length is kept.
template <class Work>
FPM_KERNEL Vec3<Work> turnedPlane(const Vec3<Work>& v, const Vec3<Work>& from, const Vec3<Work>& to)
{
    const Work onePlusCosine = Work(1) + dot(from, to);
    if (!(onePlusCosine > Work(1e-3))) return v; // opposite normals: no smallest rotation exists
    return v - (dot(to, v) / onePlusCosine) * (from + to);
}

/// Vector turned into a plane by the smallest rotation; its length is kept.
template <class Work>
FPM_KERNEL Vec3<Work> intoPlane(const Vec3<Work>& v, const Vec3<Work>& normal)
{
    const Vec3<Work> part = inPlane(v, normal);
    const Work square = dot(part, part);
    return square > 0 ? squareRoot(dot(v, v) / square) * part : part;
}

template <class Work>
FPM_KERNEL Vec3<Work> unit(const Vec3<Work>& v)
{
    const Work length = squareRoot(dot(v, v));
    return length > 0 ? (Work(1) / length) * v : v;
}

/// Orthonormal frame convected with a face: e1 along the xi tangent at its centre.
template <class Work>
struct FaceFrame {
    Vec3<Work> e1, e2, normal;

    FPM_KERNEL explicit FaceFrame(const FaceCorners<Work>& face)
    {
        const Vec3<Work>* x = face.corner;
        normal = unit(cross(x[2] - x[0], x[3] - x[1]));
        e1 = unit(inPlane((x[1] - x[0]) + (x[2] - x[3]), normal));
        e2 = cross(normal, e1);
    }
};

/// Orthonormal frame convected with the material point (xi, eta) of a face: by the mean turn of
/// both tangents, so the numbering of the corners does not matter.
template <class Work>
struct PointFrame {
    Vec3<Work> e1, e2, normal;

    FPM_KERNEL PointFrame(const FaceCorners<Work>& face, Work xi, Work eta)
    {
        Vec3<Work> offset, t1, t2;
        evaluateFace(face, xi, eta, offset, t1, t2);
        normal = faceNormal(face, t1, t2);
        e1 = unit(unit(t1) + unit(t2));
        e2 = cross(normal, e1);
    }
};
/// Components of a vector in an orthonormal frame (FaceFrame, PointFrame), and back.
template <class Frame, class Work>
FPM_KERNEL Vec3<Work> componentsIn(const Frame& frame, const Vec3<Work>& v)
{
    return {dot(v, frame.e1), dot(v, frame.e2), dot(v, frame.normal)};
}
template <class Frame, class Work>
FPM_KERNEL Vec3<Work> vectorIn(const Frame& frame, const Vec3<Work>& c)
{
    return c.x * frame.e1 + c.y * frame.e2 + c.z * frame.normal;
}

/// Corner forces without resultant that have the moment of a couple, conjugate to the spin of the
/// face. Friction acts with F at the contactor and -N_I F at the corners; with the couple its total
/// moment is zero, and its work is F times the objective slip increment (delta x_c - delta x_p + g
/// delta n) . F (Curnier, He and Klarbring 1995; Poulios and Renard 2015) for any motion of the
/// five nodes: a common rigid motion does no work.
template <class Work>
struct CornerCouple {
    Work xi = 0, eta = 0; ///< where the shape functions are differentiated
    Vec3<Work> alongXi{0, 0, 0}, alongEta{0, 0, 0};

    CornerCouple() = default;
    /// Couple of a force F on the contactor with -F on the face at (atXi, atEta).
    FPM_KERNEL
    CornerCouple(const FaceCorners<Work>& face, Work atXi, Work atEta, const Vec3<Work>& force)
        : xi(atXi),
          eta(atEta)
    {
        Vec3<Work> lever, t1, t2, unused;
        evaluateFace(face, xi, eta, lever, t1, t2);
        const Vec3<Work>* x = face.corner;
        const Vec3<Work> middle = Work(0.125) * cross(x[2] - x[0], x[3] - x[1]);
        Vec3<Work> area = cross(t1, t2);
        if (!(dot(area, area) > Work(1e-4) * dot(middle, middle))) { // near a collapsed side
            xi = eta = 0;
            evaluateFace(face, xi, eta, unused, t1, t2);
            area = middle;
        }
        const Work square = dot(area, area);
        if (!(square > 0)) return;
        Vec3<Work> across = force;
        const bool onXi = xi * xi >= Work(1), onEta = eta * eta >= Work(1);
        if (onXi != onEta) { // on an edge its two corners balance it, whichever of the two faces is
                             // meant
            const Vec3<Work> edge = onXi ? t2 : t1;
            const Work part = dot(force, edge) / dot(edge, edge);
            (onXi ? alongEta : alongXi) = part * lever;
            across = force - part * edge;
        }
        // w x t^alpha with the dual tangents t^alpha has the moment w + (w . n) n.
        const Vec3<Work> couple = (Work(1) / square) * cross(across, lever);
        const Work drill = Work(0.5) * dot(couple, area);
        alongXi += drill * t2 - dot(couple, t2) * area;
        alongEta += dot(couple, t1) * area - drill * t1;
    }
    /// Force on corner k.
    FPM_KERNEL Vec3<Work> at(int k) const
    {
        const Work one = Work(1), x = k == 1 || k == 2 ? one : -one, e = k > 1 ? one : -one;
        return (Work(0.25) * x * (one + e * eta)) * alongXi
               + (Work(0.25) * e * (one + x * xi)) * alongEta;
    }
};

} // namespace fpm
