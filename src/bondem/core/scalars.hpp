// Number types, constants and elementary functions of the core, access to numbers shared by threads, and prefetching.
#pragma once
#if defined(__CUDACC_RTC__)  // a GPU: its compiler has no headers, and functions without specifier run on the device
using int32_t = int;
using uint8_t = unsigned char;
using uint32_t = unsigned int;
using int64_t = long long;
using uint64_t = unsigned long long;
#define BONDEM_INLINE __forceinline__
#else
#include <stddef.h>
#include <stdint.h>
#define BONDEM_INLINE inline __attribute__((always_inline))
#define BONDEM_LANES  // registers of several numbers
#endif

namespace bondem {

using Index = int64_t;  // NumPy's int64
using Short = uint32_t;  // element numbers in lists that are read often
using Byte = uint8_t;

#if defined(__CUDACC_RTC__)
constexpr double infinity = __builtin_bit_cast(double, uint64_t(0x7ff0000000000000));
constexpr double undefined = __builtin_bit_cast(double, uint64_t(0x7ff8000000000000));

inline double root(double a) { return ::sqrt(a); }
inline double floor(double a) { return ::floor(a); }
inline double nearest(double a) { return ::rint(a); }
inline double absolute(double a) { return ::fabs(a); }
inline double arc_tangent(double y, double x) { return ::atan2(y, x); }
#else
constexpr double infinity = __builtin_inf();
constexpr double undefined = __builtin_nan("");

inline double root(double a) { return __builtin_sqrt(a); }
inline double floor(double a) { return __builtin_floor(a); }
// Rounds to the nearest whole number, halves to the even one.
inline double nearest(double a) { return __builtin_rint(a); }
inline double absolute(double a) { return __builtin_fabs(a); }
inline double arc_tangent(double y, double x) { return __builtin_atan2(y, x); }
#endif

// Access to numbers that several threads write: a value that is the same from all, a sum, bits, a count, and the
// largest of numbers that are not negative, whose bits have their order.
#if defined(__CUDACC_RTC__)
template <class T> inline void put_shared(T &place, T value) { *const_cast<volatile T *>(&place) = value; }
template <class T> inline T get_shared(const T &place) { return *const_cast<const volatile T *>(&place); }
inline Index add_to_shared(Index &place, Index value) {
    return Index(atomicAdd(reinterpret_cast<unsigned long long *>(&place), (unsigned long long)value));
}
inline void set_in_shared(Index &place, Index bits) {
    atomicOr(reinterpret_cast<unsigned long long *>(&place), (unsigned long long)bits);
}
inline void raise_shared(double &place, double value) {
    atomicMax(reinterpret_cast<unsigned long long *>(&place), __builtin_bit_cast(unsigned long long, value));
}
#else
template <class T> inline void put_shared(T &place, T value) { __atomic_store_n(&place, value, __ATOMIC_RELAXED); }
template <class T> inline T get_shared(const T &place) { return __atomic_load_n(&place, __ATOMIC_RELAXED); }
inline Index add_to_shared(Index &place, Index value) { return __atomic_fetch_add(&place, value, __ATOMIC_RELAXED); }
inline void set_in_shared(Index &place, Index bits) { __atomic_fetch_or(&place, bits, __ATOMIC_RELAXED); }
inline void raise_shared(double &place, double value) {
    Index *const word = reinterpret_cast<Index *>(&place);
    const Index bits = __builtin_bit_cast(Index, value);
    Index now = get_shared(*word);
    while (now < bits && !__atomic_compare_exchange_n(word, &now, bits, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
}
#endif
inline Index count_up(Index &count) { return add_to_shared(count, 1); }

// Prefetches a line of memory.
BONDEM_INLINE void prefetch([[maybe_unused]] const void *at) {
#if defined(BONDEM_LANES)
    __builtin_prefetch(at);
#endif
}

template <class T> inline T least(T a, T b) { return b < a ? b : a; }
template <class T> inline T most(T a, T b) { return b > a ? b : a; }
template <class T> inline T within(T a, T low, T high) { return least(most(a, low), high); }
template <class T> inline void exchange(T &a, T &b) {
    T first = a;
    a = b;
    b = first;
}

}  // namespace bondem
