#pragma once

#include "kernels/element/Hexahedron.h"
#include "kernels/material/Materials.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace fpm::test {

/// Corner coordinates or corner vectors of a hexahedron, one row a corner in VTK order.
using Corners = Eigen::Matrix<double, 8, 3>;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

inline constexpr double cornerSign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                            {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/// Brick centred at the origin.
inline Corners brick(double s1, double s2, double s3)
{
    Corners x;
    for (int i = 0; i < 8; ++i)
        x.row(i) << cornerSign[i][0] * s1 / 2, cornerSign[i][1] * s2 / 2, cornerSign[i][2] * s3 / 2;
    return x;
}

inline double uniform(std::mt19937& random, double low = -1, double high = 1)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline Corners randomCorners(std::mt19937& random, double size)
{
    return Corners::NullaryExpr([&] { return size * uniform(random); });
}

inline Matrix randomMatrix(std::mt19937& random, double size)
{
    return Matrix::NullaryExpr([&] { return size * uniform(random); });
}

inline Matrix randomSymmetric(std::mt19937& random, double size)
{
    const Matrix m = randomMatrix(random, size);
    return (m + m.transpose()) / 2;
}

inline Vector randomAxis(std::mt19937& random)
{
    Vector axis;
    do axis << uniform(random), uniform(random), uniform(random);
    while (axis.norm() < 0.1 || axis.norm() > 1);
    return axis.normalized();
}

inline Matrix turn(const Vector& axis, double angle)
{
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// Brick of random proportions in a random position, its corners moved by up to `warp` of its
/// edges: every face is warped.
inline Corners warpedHexahedron(std::mt19937& random, double warp = 0.2)
{
    const double s[3] = {uniform(random, 0.5, 2), uniform(random, 0.5, 2), uniform(random, 0.5, 2)};
    Corners x = brick(s[0], s[1], s[2]);
    for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c) x(i, c) += warp * s[c] * uniform(random);
    return x * turn(randomAxis(random), uniform(random, 0, 3)).transpose();
}

/// Modes of corner values; the corner coordinates may be rounded to T first, as a kernel reads
/// them.
template <class T = double>
Modes<T> modesOf(const Corners& corners)
{
    Modes<T> out;
    T c[8], m[8];
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 8; ++i) c[i] = T(corners(i, k));
        toModes(c, m);
        for (int i = 0; i < 8; ++i)
            (k == 0 ? out.mode[i].x : k == 1 ? out.mode[i].y : out.mode[i].z) = m[i];
    }
    return out;
}

/// Corner values of modes 1..7.
template <class T>
Corners cornersOf(const Modes<T>& modes)
{
    Corners out;
    T c[8], m[8];
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 8; ++i)
            m[i] = k == 0 ? modes.mode[i].x : k == 1 ? modes.mode[i].y : modes.mode[i].z;
        toCorners(m, c);
        for (int i = 0; i < 8; ++i) out(i, k) = double(c[i]);
    }
    return out;
}

/// B_iI = dV/dx_iI as rows of corners.
inline Corners cornerGradient(const Gradient<double>& gradient)
{
    Modes<double> modes{};
    for (int m = 1; m < 7; ++m) modes.mode[m] = gradient.g[m];
    return cornersOf(modes) / 64;
}

inline double volumeOf(const Corners& x)
{
    return meanGradient(modesOf(x)).volume64 / 64;
}

template <class T>
Matrix matrixOf(const Mat3<T>& m)
{
    return (Matrix() << m.x.x, m.x.y, m.x.z, m.y.x, m.y.y, m.y.z, m.z.x, m.z.y, m.z.z).finished();
}

template <class T>
Matrix matrixOf(const Sym3<T>& s)
{
    return matrixOf(matrix(s));
}

template <class T = double>
Sym3<T> symmetric(const Matrix& m)
{
    return {T(m(0, 0)), T(m(1, 1)), T(m(2, 2)), T(m(0, 1)), T(m(1, 2)), T(m(2, 0))};
}

inline double mises(const Matrix& stress)
{
    const Matrix s = stress - stress.trace() / 3 * Matrix::Identity();
    return std::sqrt(1.5) * s.norm();
}

/// Constants of a material without bulk viscosity that yields at `yieldStress`.
template <class T = double>
MaterialConstants<T>
materialOf(double young, double poisson, double yieldStress = 1e30, double plasticModulus = 0)
{
    MaterialConstants<T> m{};
    const double mu = young / (2 * (1 + poisson));
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    m.lambda = T(lambda);
    m.twoMu = T(2 * mu);
    m.threeMu = T(3 * mu);
    m.pressureWaveModulus = T(lambda + 2 * mu);
    m.young = T(young);
    m.poisson = T(poisson);
    m.hourglass = T(1);
    m.rows = 1;
    m.stress[0] = T(yieldStress);
    m.slope[0] = T(plasticModulus);
    return m;
}

/// One element that follows prescribed corner positions.
template <class Material, class Hourglass, class T = double>
struct Element {
    MaterialConstants<T> material;
    Corners x;
    double mass = 1;
    T strainPoint = T(0.5);
    ElementState<T> state{};
    ElementStep<T> step{};
    Corners force = Corners::Zero(); ///< internal force on the corners after the last step
    double work = 0;                 ///< internal and hourglass, all steps

    Element(const MaterialConstants<T>& m, const Corners& start) : material(m), x(start) {}

    /// Moves the corners to `next`; `rate` is 1 / step.
    void advance(const Corners& next, double rate = 0)
    {
        const Corners increment = next - x, shape = next.rowwise() - next.row(0);
        Modes<T> w = modesOf<T>(increment);
        step = updateHexahedron<Material, Hourglass>(material, modesOf<T>(shape), w, T(mass),
                                                     T(rate), strainPoint, state);
        if constexpr (Material::plastic)
            state.equivalentPlasticStrain += step.plasticStrainIncrement;
        if constexpr (Material::general) state.temperatureRise += step.temperatureIncrement;
        force = cornersOf(w);
        work += double(step.internal) + double(step.hourglass);
        x = next;
    }
    Matrix stress() const { return matrixOf(state.stress); }
};

/// Work of corner forces on corner displacements.
inline double workOf(const Corners& force, const Corners& displacement)
{
    return force.cwiseProduct(displacement).sum();
}

} // namespace fpm::test
