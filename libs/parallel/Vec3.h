#pragma once

#include "parallel/Math.h"

namespace fpm {

/// Three components of any number type.
template <class T>
struct Vec3 {
    T x, y, z;

    friend FPM_KERNEL Vec3 operator+(const Vec3& a, const Vec3& b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend FPM_KERNEL Vec3 operator-(const Vec3& a, const Vec3& b)
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend FPM_KERNEL Vec3 operator*(const T& s, const Vec3& a)
    {
        return {s * a.x, s * a.y, s * a.z};
    }
    FPM_KERNEL Vec3 operator-() const { return {-x, -y, -z}; }
    FPM_KERNEL Vec3& operator+=(const Vec3& a) { return *this = *this + a; }
};

template <class T>
FPM_KERNEL T dot(const Vec3<T>& a, const Vec3<T>& b)
{
    return fusedMultiplyAdd(a.x, b.x, fusedMultiplyAdd(a.y, b.y, a.z * b.z));
}
template <class T>
FPM_KERNEL Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b)
{
    return {fusedMultiplyAdd(a.y, b.z, -(a.z * b.y)), fusedMultiplyAdd(a.z, b.x, -(a.x * b.z)),
            fusedMultiplyAdd(a.x, b.y, -(a.y * b.x))};
}
/// c + s a
template <class T>
FPM_KERNEL Vec3<T> multiplyAdd(const T& s, const Vec3<T>& a, const Vec3<T>& c)
{
    return {fusedMultiplyAdd(s, a.x, c.x), fusedMultiplyAdd(s, a.y, c.y),
            fusedMultiplyAdd(s, a.z, c.z)};
}

/// Rows of a 3 x 3 matrix.
template <class T>
struct Mat3 {
    Vec3<T> x, y, z;
    friend FPM_KERNEL Vec3<T> operator*(const Mat3& m, const Vec3<T>& a)
    {
        return {dot(m.x, a), dot(m.y, a), dot(m.z, a)};
    }
    friend FPM_KERNEL Mat3 operator+(const Mat3& a, const Mat3& b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
};
template <class T>
FPM_KERNEL Mat3<T> transpose(const Mat3<T>& m)
{
    return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
template <class T>
FPM_KERNEL Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b)
{
    const Mat3<T> columns = transpose(b);
    return {columns * a.x, columns * a.y, columns * a.z};
}
/// m += a b^T
template <class T>
FPM_KERNEL void addOuter(Mat3<T>& m, const Vec3<T>& a, const Vec3<T>& b)
{
    m.x = multiplyAdd(a.x, b, m.x);
    m.y = multiplyAdd(a.y, b, m.y);
    m.z = multiplyAdd(a.z, b, m.z);
}

/// Symmetric tensor; xy, yz, zx are tensor (not engineering) components. Storage order S.
template <class T>
struct Sym3 {
    T xx, yy, zz, xy, yz, zx;
    friend FPM_KERNEL Sym3 operator+(const Sym3& a, const Sym3& b)
    {
        return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
    }
    friend FPM_KERNEL Sym3 operator*(const T& s, const Sym3& a)
    {
        return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
    }
};
template <class T>
FPM_KERNEL Mat3<T> matrix(const Sym3<T>& s)
{
    return {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
}
/// a : b
template <class T>
FPM_KERNEL T contract(const Sym3<T>& a, const Sym3<T>& b)
{
    const T shear = fusedMultiplyAdd(a.xy, b.xy, fusedMultiplyAdd(a.yz, b.yz, a.zx * b.zx));
    return fusedMultiplyAdd(
        a.xx, b.xx, fusedMultiplyAdd(a.yy, b.yy, fusedMultiplyAdd(a.zz, b.zz, shear + shear)));
}

} // namespace fpm
