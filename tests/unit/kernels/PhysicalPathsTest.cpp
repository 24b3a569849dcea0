#include "unit/kernels/Element.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

using namespace fpm;
using namespace fpm::test;

namespace {

constexpr double young = 70000, poisson = 0.3;

/// Corner vectors u_i = a_i times the sign pattern of a mode (0: eta zeta, 1: zeta xi, 2: xi eta,
/// 3: xi eta zeta).
Corners hourglass(int mode, const Vector& a)
{
    Corners u;
    for (int i = 0; i < 8; ++i) {
        const double* s = cornerSign[i];
        const double pattern =
            mode == 3 ? s[0] * s[1] * s[2] : s[(mode + 1) % 3] * s[(mode + 2) % 3];
        u.row(i) = pattern * a.transpose();
    }
    return u;
}

/// An element on a prescribed path, and beside it one whose form has coefficient 0: what the mean
/// stress does is the same in both.
struct Pair {
    Element<Elastic, PhysicalHourglass> with, without;

    explicit Pair(const Corners& x)
        : with(materialOf(young, poisson), x),
          without(materialOf(young, poisson), x)
    {
        without.material.hourglass = 0;
    }
    Corners force() const { return with.force - without.force; }
    /// Work of the hourglass forces, trapezoidal.
    double workAlong(const std::function<Corners(double)>& place, int steps)
    {
        double work = 0;
        for (int n = 1; n <= steps; ++n) {
            const Corners before = force(), from = with.x, to = place(double(n) / steps);
            with.advance(to);
            without.advance(to);
            work += workOf((before + force()) / 2, to - from);
        }
        return work;
    }
};

/// Energy lost in a cycle that hourglasses, deforms by F = 1 + size e_i e_k, takes the first back
/// and then the second, over size times the energy of the hourglassing.
double lostInCycle(const Corners& x, const Corners& mode, const Matrix& deformation, double size)
{
    Pair pair(x);
    const Matrix one = Matrix::Identity();
    const auto at = [&](double h, double g) -> Corners {
        const Matrix f = one + g * (deformation - one);
        return (x + h * mode) * f.transpose();
    };
    const int steps = 2000;
    const double bent = pair.workAlong([&](double t) { return at(t, 0); }, steps);
    double total = bent;
    total += pair.workAlong([&](double t) { return at(1, t); }, steps);
    total += pair.workAlong([&](double t) { return at(1 - t, 1); }, steps);
    total += pair.workAlong([&](double t) { return at(0, 1 - t); }, steps);
    EXPECT_GT(bent, 0);
    return total / (size * bent);
}

} // namespace

// Bend or twist, deform, unbend, deform back: the force form kept between steps made 2 (l - 1) of
// the bending energy in such a cycle, or lost it.
TEST(PhysicalPaths, NoClosedPathMakesEnergy)
{
    const double size = 0.1;
    for (const Corners& x : {brick(1, 1, 1), brick(2, 1.5, 0.5)})
        for (int mode = 0; mode < 4; ++mode)
            for (int direction = 0; direction < 3; ++direction) {
                Vector a = Vector::Zero();
                a[direction] = 1e-3;
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k) {
                        Matrix f = Matrix::Identity();
                        f(i, k) += size;
                        EXPECT_NEAR(lostInCycle(x, hourglass(mode, a), f, size), 0, 1e-3)
                            << "mode " << mode << " direction " << direction << " F_" << i << k;
                    }
            }
}
