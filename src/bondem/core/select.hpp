// Choice between two numbers without branches. A comparison gives a mask, by which `select` chooses one of both
// numbers in each lane of a vector register.
#pragma once
#include "lanes.hpp"
#include "vector3.hpp"

namespace bondem {

template <class T> using Mask = decltype(T{} < T{});

BONDEM_INLINE double select(bool first, double a, double b) { return first ? a : b; }
BONDEM_INLINE bool any(bool a) { return a; }
BONDEM_INLINE bool opposite(bool a) { return !a; }

#if defined(BONDEM_LANES)

BONDEM_INLINE Lanes select(Mask<Lanes> first, Lanes a, Lanes b) { return first ? a : b; }
BONDEM_INLINE Mask<Lanes> opposite(Mask<Lanes> a) { return ~a; }
#if defined(__clang__)
BONDEM_INLINE bool any(Mask<Lanes> a) { return __builtin_reduce_or(a) != 0; }
#else
BONDEM_INLINE bool any(Mask<Lanes> a) {
    bool found = false;
    for (int n = 0; n < lanes; n++) found |= a[n] != 0;
    return found;
}
#endif

#endif

// One number in all lanes.
template <class T> BONDEM_INLINE T all(double a) { return T{} + a; }
// The number or 0, whichever is larger.
template <class T> BONDEM_INLINE T positive(T a) { return select(a > T{}, a, T{}); }
template <class T> BONDEM_INLINE Vector3<T> select(Mask<T> first, const Vector3<T> &a, const Vector3<T> &b) {
    return {select(first, a.x, b.x), select(first, a.y, b.y), select(first, a.z, b.z)};
}

}  // namespace bondem
