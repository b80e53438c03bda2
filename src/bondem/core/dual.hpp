// Dual numbers: a value with its derivative in one direction, for automatic differentiation. Laws evaluated with dual
// numbers also return derivatives of their results, exact to rounding.
#pragma once
#include "symmetric3.hpp"

namespace bondem {

// Value and derivative of a number, or of lanes of numbers. A constant has the derivative 0; after inlining, the
// compiler knows the constants. A product is fused with the number added to it, as in an expression of numbers.
template <class S> struct Dual {
    S v{}, d{};
    bool moves = false;

    struct Product;

    Dual() = default;
    BONDEM_INLINE Dual(S value) : v(value) {}
    BONDEM_INLINE Dual(S value, S slope, bool changes = true) : v(value), d(slope), moves(changes) {}
    BONDEM_INLINE Dual(const Product &p) : Dual(p.plus(false, Dual())) {}
    BONDEM_INLINE friend Dual operator-(Dual a) { return {-a.v, -a.d, a.moves}; }
    BONDEM_INLINE friend Dual operator+(Dual a, Dual b) {
        return {a.v + b.v, a.moves ? b.moves ? a.d + b.d : a.d : b.d, a.moves || b.moves};
    }
    BONDEM_INLINE friend Dual operator-(Dual a, Dual b) { return a + -b; }
    BONDEM_INLINE friend Product operator*(Dual a, Dual b) { return {a, b}; }
    BONDEM_INLINE friend Dual operator*(double s, Dual a) { return {s * a.v, s * a.d, a.moves}; }
    BONDEM_INLINE friend Dual operator*(Dual a, double s) { return s * a; }
    BONDEM_INLINE friend Dual operator/(double s, Dual a) { return {s / a.v, -s / a.v * a.d / a.v, a.moves}; }
    BONDEM_INLINE friend bool operator<(Dual a, double b) { return a.v < b; }
    BONDEM_INLINE friend Dual root(Dual a) { return {root(a.v), 0.5 * a.d / root(a.v), a.moves}; }
    BONDEM_INLINE friend Dual nearest(Dual a) { return nearest(a.v); }
};

template <class S> struct Dual<S>::Product {
    Dual a, b;

    // x y + z without the terms that are constant zeros.
    static BONDEM_INLINE S joined(bool p, S x, S y, bool q, S z) { return p ? q ? x * y + z : x * y : z; }
    BONDEM_INLINE Dual plus(bool some, Dual c) const {
        const S d = joined(b.moves, a.v, b.d, c.moves, c.d);
        return {joined(true, a.v, b.v, some, c.v), joined(a.moves, a.d, b.v, b.moves || c.moves, d),
                a.moves || b.moves || c.moves};
    }
    BONDEM_INLINE friend Dual operator+(Dual c, const Product &p) { return p.plus(true, c); }
    BONDEM_INLINE friend Dual operator-(Dual c, const Product &p) { return Product{-p.a, p.b}.plus(true, c); }
};

// The result of a pass: a number, or the derivative of a dual.
template <class T> BONDEM_INLINE T written(T a) { return a; }
template <class S> BONDEM_INLINE S written(Dual<S> a) { return a.d; }
template <class S> BONDEM_INLINE Vector3<S> written(Vector3<Dual<S>> a) { return {a.x.d, a.y.d, a.z.d}; }

// A constant vector or tensor in numbers of type T, such as duals.
template <class T> BONDEM_INLINE Vector3<T> constant(const Vector &a) { return {a.x, a.y, a.z}; }
template <class T> BONDEM_INLINE Symmetric3<T> constant(const Symmetric3<double> &a) {
    return {a.xx, a.yy, a.zz, a.xy, a.xz, a.yz};
}

}  // namespace bondem
