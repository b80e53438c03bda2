// Vector registers of several numbers (lanes), as the number type of the laws in passes over many bonds or elements.
//
// The templates of `laws/` use `Lanes` as a number with + - * /, negation, square root and rounding. Each lane has
// the bits of the scalar result. Functions read and write rows of eight numbers, one row per lane, as eight `Lanes`.
#pragma once
#include "scalars.hpp"

namespace bondem {

// Sign of a number: -1, 0 or 1.
BONDEM_INLINE double sign(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0; }
BONDEM_INLINE bool all_below(double a, double bound) { return a < bound; }

// A row of eight numbers of a table, or as many rows as there are lanes, column by column.
template <class T> struct Row {
    T column[8];
};

#if !defined(BONDEM_LANES)
// Four numbers that are added and scaled together.
struct Four {
    double of[4];

    BONDEM_INLINE double operator[](int d) const { return of[d]; }
    BONDEM_INLINE Four operator-() const { return {{-of[0], -of[1], -of[2], -of[3]}}; }
    BONDEM_INLINE void operator+=(const Four &a) {
        for (int d = 0; d < 4; d++) of[d] += a.of[d];
    }
};
BONDEM_INLINE Four operator*(double s, const Four &a) { return {{s * a.of[0], s * a.of[1], s * a.of[2], s * a.of[3]}}; }
using FourInMemory = Four;
#endif

#if defined(BONDEM_LANES)

#if defined(__AVX512F__)
constexpr int lanes = 8;
#else
constexpr int lanes = 4;  // two registers on a CPU with narrower ones
#endif
typedef double Lanes __attribute__((vector_size(lanes * 8)));
typedef double LanesInMemory __attribute__((vector_size(lanes * 8), aligned(8)));
typedef double FourInMemory __attribute__((vector_size(32), aligned(8)));
typedef double Four __attribute__((vector_size(32)));

// Functions of a number, lane by lane.
#if defined(__clang__)
#define BONDEM_EACH_LANE(Several, function, builtin) \
    BONDEM_INLINE Several function(Several a) { return __builtin_elementwise_##builtin(a); }
#else
#define BONDEM_EACH_LANE(Several, function, builtin)                                             \
    BONDEM_INLINE Several function(Several a) {                                                  \
        for (unsigned n = 0; n < sizeof(a) / sizeof(double); n++) a[n] = function(double(a[n])); \
        return a;                                                                                \
    }
#endif
BONDEM_EACH_LANE(Lanes, root, sqrt)
BONDEM_EACH_LANE(Lanes, nearest, rint)
BONDEM_EACH_LANE(Lanes, absolute, abs)
#if defined(__AVX512F__)
BONDEM_EACH_LANE(Four, root, sqrt)
BONDEM_EACH_LANE(Four, nearest, rint)
#endif
#undef BONDEM_EACH_LANE

BONDEM_INLINE Lanes sign(Lanes a) {
    const Lanes zero = {}, one = zero + 1.0;
    return a > zero ? one : a < zero ? -one : zero;
}
BONDEM_INLINE bool all_below(Lanes a, double bound) {
    bool below = true;
    for (int n = 0; n < lanes; n++) below &= a[n] < bound;
    return below;
}
// Result of a comparison of lanes; `bits_of` returns one bit per lane, the lowest for the first.
typedef decltype(Lanes{} < Lanes{}) Compared;
#if defined(__clang__)
BONDEM_INLINE unsigned bits_of(Compared compared) {
    typedef bool Bits __attribute__((ext_vector_type(lanes)));
    const Bits bits = __builtin_convertvector(compared, Bits);
    unsigned char byte;
    __builtin_memcpy(&byte, &bits, 1);
    return byte & ((1u << lanes) - 1u);
}
#else
BONDEM_INLINE unsigned bits_of(Compared compared) {
    unsigned bits = 0;
    for (int n = 0; n < lanes; n++) bits |= unsigned(compared[n] != 0) << n;
    return bits;
}
#endif

// ---- memory

BONDEM_INLINE Lanes load(const double *from) { return *reinterpret_cast<const LanesInMemory *>(from); }
BONDEM_INLINE void store(double *to, Lanes a) { *reinterpret_cast<LanesInMemory *>(to) = a; }
// Types of numbers that are stored in four bytes instead of eight.
typedef int32_t WholeInMemory __attribute__((vector_size(lanes * 4), aligned(4)));
typedef float SingleInMemory __attribute__((vector_size(lanes * 4), aligned(4)));
BONDEM_INLINE Lanes load(const int32_t *from) {
    return __builtin_convertvector(*reinterpret_cast<const WholeInMemory *>(from), Lanes);
}
BONDEM_INLINE Lanes load(const float *from) {
    return __builtin_convertvector(*reinterpret_cast<const SingleInMemory *>(from), Lanes);
}
// Writes lanes known … lanes - 1.
BONDEM_INLINE void store_behind(double *to, Lanes a, int known) {
    if (__builtin_expect(known == 0, 1))
        store(to, a);
    else
        for (int n = known; n < lanes; n++) to[n] = a[n];
}

BONDEM_INLINE void transpose_four(Four *r) {
    const Four low = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
    const Four high = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
    const Four low2 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
    const Four high2 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
    r[0] = __builtin_shufflevector(low, low2, 0, 1, 4, 5);
    r[1] = __builtin_shufflevector(high, high2, 0, 1, 4, 5);
    r[2] = __builtin_shufflevector(low, low2, 2, 3, 6, 7);
    r[3] = __builtin_shufflevector(high, high2, 2, 3, 6, 7);
}

// Rows of the first and of the second ends of bonds, gathered in an order that needs few registers.
template <class T> struct PairOfRows {
    Row<T> first, second;
};

#if defined(__AVX512F__)

// Exchanges columns with rows at a distance of 1, 2 and 4.
BONDEM_INLINE void transpose(Row<Lanes> &rows) {
    Lanes *r = rows.column, s[8];
    for (int n = 0; n < 8; n += 2) {
        s[n] = __builtin_shufflevector(r[n], r[n + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        s[n + 1] = __builtin_shufflevector(r[n], r[n + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int n = 0; n < 8; n++)
        if (!(n & 2)) {
            r[n] = __builtin_shufflevector(s[n], s[n + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            r[n + 2] = __builtin_shufflevector(s[n], s[n + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (int n = 0; n < 4; n++) {
        s[n] = __builtin_shufflevector(r[n], r[n + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        s[n + 4] = __builtin_shufflevector(r[n], r[n + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
    for (int n = 0; n < 8; n++) r[n] = s[n];
}
BONDEM_INLINE Row<Lanes> gather(const double *table, const Short *place) {
    Row<Lanes> rows;
    for (int n = 0; n < lanes; n++) rows.column[n] = load(table + 8 * uint64_t(place[n]));
    transpose(rows);
    return rows;
}
BONDEM_INLINE PairOfRows<Lanes> gather(const double *table, const Short *first, const Short *second) {
    return {gather(table, first), gather(table, second)};
}
BONDEM_INLINE Row<Lanes> gather_sums(const double *table, const Short *first, const Short *second) {
    Row<Lanes> rows;
    for (int n = 0; n < lanes; n++)
        rows.column[n] = load(table + 8 * uint64_t(first[n])) + load(table + 8 * uint64_t(second[n]));
    transpose(rows);
    return rows;
}
BONDEM_INLINE void scatter(double *table, const Short *place, Row<Lanes> rows) {
    transpose(rows);
    for (int n = 0; n < lanes; n++) store(table + 8 * uint64_t(place[n]), rows.column[n]);
}
BONDEM_INLINE void accumulate(double *row, const Row<Lanes> &rows, int n) { store(row, load(row) + rows.column[n]); }

#else

BONDEM_INLINE void transpose(Row<Lanes> &rows) {
    transpose_four(rows.column);
    transpose_four(rows.column + 4);
}
BONDEM_INLINE void gather_half(const double *table, const Short *place, Lanes *column) {
    for (int n = 0; n < lanes; n++) column[n] = load(table + 8 * uint64_t(place[n]));
    transpose_four(column);
}
BONDEM_INLINE Row<Lanes> gather(const double *table, const Short *place) {
    Row<Lanes> rows;
    gather_half(table, place, rows.column);
    gather_half(table + 4, place, rows.column + 4);
    return rows;
}
BONDEM_INLINE PairOfRows<Lanes> gather(const double *table, const Short *first, const Short *second) {
    PairOfRows<Lanes> rows;
    for (int half = 0; half < 8; half += 4) {
        gather_half(table + half, first, rows.first.column + half);
        gather_half(table + half, second, rows.second.column + half);
    }
    return rows;
}
// Sums of the rows at the places `first` and `second` of a table, one lane per pair of places.
BONDEM_INLINE Row<Lanes> gather_sums(const double *table, const Short *first, const Short *second) {
    Row<Lanes> rows;
    for (int n = 0; n < lanes; n++) {
        const double *const a = table + 8 * uint64_t(first[n]), *const b = table + 8 * uint64_t(second[n]);
        rows.column[n] = load(a) + load(b);
        rows.column[4 + n] = load(a + 4) + load(b + 4);
    }
    transpose(rows);
    return rows;
}
BONDEM_INLINE void scatter(double *table, const Short *place, Row<Lanes> rows) {
    transpose(rows);
    for (int n = 0; n < lanes; n++) {
        store(table + 8 * uint64_t(place[n]), rows.column[n]);
        store(table + 8 * uint64_t(place[n]) + 4, rows.column[4 + n]);
    }
}
BONDEM_INLINE void accumulate(double *row, const Row<Lanes> &rows, int n) {
    store(row, load(row) + rows.column[n]);
    store(row + 4, load(row + 4) + rows.column[4 + n]);
}

#endif

// Adds rows known … lanes - 1 to rows of a table, one by one: first that of the second end of a bond, then that of
// the first. The tests are written out, because a loop over them is not unrolled.
BONDEM_INLINE void add_rows(double *table, const Short *first, const Short *second, Row<Lanes> on_first,
                            Row<Lanes> on_second, int known) {
    transpose(on_second);
    transpose(on_first);
    const auto add = [&](int n) __attribute__((always_inline)) {
        accumulate(table + 8 * uint64_t(second[n]), on_second, n);
        accumulate(table + 8 * uint64_t(first[n]), on_first, n);
    };
    if (__builtin_expect(known <= 0, 1)) add(0);
    if (__builtin_expect(known <= 1, 1)) add(1);
    if (__builtin_expect(known <= 2, 1)) add(2);
#if defined(__AVX512F__)
    if (__builtin_expect(known <= 3, 1)) add(3);
    if (__builtin_expect(known <= 4, 1)) add(4);
    if (__builtin_expect(known <= 5, 1)) add(5);
    if (__builtin_expect(known <= 6, 1)) add(6);
#endif
    add(lanes - 1);
}

// Prefetches the first cache line of later rows.
BONDEM_INLINE void prefetch(const double *table, const Short *place) {
    for (int n = 0; n < lanes; n++) __builtin_prefetch(table + 8 * uint64_t(place[n]));
}

#endif

}  // namespace bondem
