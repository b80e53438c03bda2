// Names of the numbers that all of the core uses, and the few functions of one number that it needs.
#pragma once
#include <stddef.h>
#include <stdint.h>

namespace bondem {

using Index = int64_t;  // what NumPy's int64 is
using Short = uint32_t;  // element numbers in lists that are read often

constexpr double infinity = __builtin_inf();

inline double root(double a) { return __builtin_sqrt(a); }
inline double floor(double a) { return __builtin_floor(a); }
// To the nearest whole number, halves to the even one.
inline double nearest(double a) { return __builtin_rint(a); }
inline double absolute(double a) { return __builtin_fabs(a); }

template <class T> inline T least(T a, T b) { return b < a ? b : a; }
template <class T> inline T most(T a, T b) { return b > a ? b : a; }
template <class T> inline T within(T a, T low, T high) { return least(most(a, low), high); }
template <class T> inline void exchange(T &a, T &b) {
    T kept = a;
    a = b;
    b = kept;
}

}  // namespace bondem
