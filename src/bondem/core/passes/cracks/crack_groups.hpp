// Access to the rows of cracks: `OneCrack` reads and writes one crack, `CrackGroup` as many cracks of a list as a
// vector register has lanes. Functions on cracks, such as those of `crack_places.hpp`, are templates for both.
#pragma once
#include "../../exact_sum.hpp"
#include "../../threads.hpp"
#include "../cells/facets.hpp"
#include "crack_rows.hpp"

namespace bondem {

// Reference geometry of the facet of crack k.
BONDEM_INLINE FacetShape<double> facet_shape(const CohesiveCracks &cracks, Index k) {
    const CrackShapeRow &of = shape_of(cracks, k);
    const double *const pitch = cracks.pitch.data;
    const auto lever = [&](const int32_t *b) {
        return Vector{pitch[0] * double(b[0]), pitch[1] * double(b[1]), pitch[2] * double(b[2])};
    };
    const auto share = [](const float *g) { return Vector{double(g[0]), double(g[1]), double(g[2])}; };
    return {lever(of.lever_i), lever(of.lever_j), share(of.share_i), share(of.share_j)};
}

// Data of the softening of one crack or of a group: H [N·m], and other numbers of `CrackSofteningRow`.
template <class T> struct CrackSoftening {
    Symmetric3<T> H;
    T plane, bends, brittleness, fastest, strength;
};

// The crack of facet k on a device, where its place e in arrays of lists is the number of the facet.
struct OneCrack {
    using Number = double;
    Index e, crack;
    Short i, j;

    OneCrack(const ElasticFacets &facets, Index k) : e(k), crack(k), i(facets.i(k)), j(facets.j(k)) {}

    BONDEM_INLINE Row<double> lines(const Array<double, 2> &table) const { return table.row<Row<double>>(crack); }
    BONDEM_INLINE void put(const Array<double, 2> &table, const Row<double> &all) const {
        table.row<Row<double>>(crack) = all;
    }
    BONDEM_INLINE double number(const Array<double, 2> &table, int column) const { return table(crack, column); }
    BONDEM_INLINE double number(const Array<const double, 1> &column) const { return column(crack); }
    BONDEM_INLINE void put(const Array<double, 2> &table, int column, double value) const {
        table(crack, column) = value;
    }
    BONDEM_INLINE Vector pull(const CohesiveCracks &cracks) const {
        return {cracks.pull(crack, 0), cracks.pull(crack, 1), cracks.pull(crack, 2)};
    }
    BONDEM_INLINE void put_pull(const CohesiveCracks &cracks, Vector f) const {
        cracks.pull(crack, 0) = f.x, cracks.pull(crack, 1) = f.y, cracks.pull(crack, 2) = f.z;
    }
    template <class... Tables> BONDEM_INLINE void prefetch(const Tables &...) const {}
    BONDEM_INLINE FacetShape<double> shapes(const CohesiveCracks &cracks) const { return facet_shape(cracks, crack); }
    BONDEM_INLINE CrackSoftening<double> softening(const CohesiveCracks &cracks) const {
        const CrackSofteningRow &of = softening_of(cracks, crack);
        return {{of.H[0], of.H[1], of.H[2], of.H[3], of.H[4], of.H[5]}, of.plane, of.bends, of.brittleness, of.fastest,
                of.strength};
    }
    BONDEM_INLINE bool flagged(const Array<Byte, 1> &flag) const { return flag(e) != 0; }
    BONDEM_INLINE void flag(const Array<Byte, 1> &to, const Array<Index, 1> &, Index, bool where, Byte value,
                            Index = 1) const {
        if (where) to(e) = value;
    }
    BONDEM_INLINE void put_halves(const CrackLists &lists, const Row<double> &on_i, const Row<double> &on_j,
                                  Index from = 0) const {
        *reinterpret_cast<Row<double> *>(&lists.half(half_of(crack, 0), from)) = on_i;
        *reinterpret_cast<Row<double> *>(&lists.half(half_of(crack, 1), from)) = on_j;
    }
    // Calls on(crack, place, lane) if the mask is set.
    template <class On> BONDEM_INLINE void where(bool mask, On on) const {
        if (mask) on(crack, e, 0);
    }
    static BONDEM_INLINE double lane(double a, int) { return a; }
    static BONDEM_INLINE void add(double a, ExactSum &total) { total.add(a); }
};

#if defined(BONDEM_LANES)

// ---- rows of a table, a lane each

BONDEM_INLINE Row<Lanes> gather_rows(const double *const *row) {
    Row<Lanes> all;
#if defined(__AVX512F__)
    for (int n = 0; n < lanes; n++) all.column[n] = load(row[n]);
#else
    for (int n = 0; n < lanes; n++) {
        all.column[n] = load(row[n]);
        all.column[4 + n] = load(row[n] + 4);
    }
#endif
    transpose(all);
    return all;
}
BONDEM_INLINE void scatter_rows(double *const *row, Row<Lanes> all) {
    transpose(all);
#if defined(__AVX512F__)
    for (int n = 0; n < lanes; n++) store(row[n], all.column[n]);
#else
    for (int n = 0; n < lanes; n++) {
        store(row[n], all.column[n]);
        store(row[n] + 4, all.column[4 + n]);
    }
#endif
}

// Types for columns of a row whose lanes contain two numbers of four bytes each: whole ones, or of single precision.
typedef uint64_t TwoInLanes __attribute__((vector_size(lanes * 8)));
typedef uint32_t OneInLanes __attribute__((vector_size(lanes * 4)));
typedef int32_t WholeLanes __attribute__((vector_size(lanes * 4)));
typedef float SingleLanes __attribute__((vector_size(lanes * 4)));
BONDEM_INLINE OneInLanes one_of(Lanes column, int which) {
    return __builtin_convertvector(which == 0 ? (TwoInLanes)column : (TwoInLanes)column >> 32, OneInLanes);
}
BONDEM_INLINE Lanes whole_of(const Row<Lanes> &row, int number) {
    return __builtin_convertvector((WholeLanes)one_of(row.column[number / 2], number % 2), Lanes);
}
BONDEM_INLINE Lanes single_of(const Row<Lanes> &row, int number) {
    return __builtin_convertvector((SingleLanes)one_of(row.column[number / 2], number % 2), Lanes);
}

// ---- a group of cracks

// Group of cracks of a list, as many as there are lanes, from place e on.
struct CrackGroup {
    using Number = Lanes;
    Index e;
    int known;  // number of cracks; lanes after them repeat the last one, with the same results
    const Index *crack;
    const Short *i, *j;

    CrackGroup(const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index e,
               Index count)
        : e(e), known(int(least(count - e, Index(lanes)))), crack(list.data + e), i(at_i.data + e),
            j(at_j.data + e) {}

    // Row of each crack in a table, as eight columns with one lane per crack.
    BONDEM_INLINE Row<Lanes> lines(const Array<double, 2> &table) const {
        const double *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = table.data + 8 * crack[n];
        return gather_rows(row);
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, const Row<Lanes> &all) const {
        double *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = table.data + 8 * crack[n];
        scatter_rows(row, all);
    }
    // Numbers of a column, one per crack of a group.
    BONDEM_INLINE Lanes number(const Array<double, 2> &table, int column) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = table.data[8 * crack[n] + column];
        return all;
    }
    BONDEM_INLINE Lanes number(const Array<const double, 1> &column) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = column.data[crack[n]];
        return all;
    }
    // Forces of the cracks of a group on their cells i.
    BONDEM_INLINE Vector3<Lanes> pull(const CohesiveCracks &cracks) const {
        Lanes f[3];
        for (int part = 0; part < lanes; part += 4) {
            Four r[4];
            for (int n = 0; n < 4; n++)
                r[n] = *reinterpret_cast<const FourInMemory *>(cracks.pull.data + 4 * crack[part + n]);
            transpose_four(r);
            for (int d = 0; d < 3; d++)
                for (int n = 0; n < 4; n++) f[d][part + n] = r[d][n];
        }
        return {f[0], f[1], f[2]};
    }
    BONDEM_INLINE void put_pull(const CohesiveCracks &cracks, Vector3<Lanes> f) const {
        for (int part = 0; part < lanes; part += 4) {
            Four r[4] = {};
            for (int n = 0; n < 4; n++) r[0][n] = f.x[part + n], r[1][n] = f.y[part + n], r[2][n] = f.z[part + n];
            transpose_four(r);
            for (int n = 0; n < 4; n++)
                *reinterpret_cast<FourInMemory *>(cracks.pull.data + 4 * crack[part + n]) = r[n];
        }
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, int column, Lanes all) const {
        for (int n = 0; n < lanes; n++) table.data[8 * crack[n] + column] = all[n];
    }
    // Prefetches the rows of tables for cracks 24 places later; lists have room after their end, which is read here.
    template <class... Tables> BONDEM_INLINE void prefetch(const Tables &...tables) const {
        constexpr Index ahead = 24;
#pragma clang loop unroll(full)
        for (int n = 0; n < lanes; n++) {
            const Index k = crack[ahead + n];
            (ask(tables, k), ...);
        }
    }
    // Shapes of the facets of a group of cracks.
    BONDEM_INLINE FacetShape<Lanes> shapes(const CohesiveCracks &cracks) const {
        const Row<Lanes> of = lines(cracks.shape);
        const double *const pitch = cracks.pitch.data;
        const auto lever = [&](int c) {
            return Vector3<Lanes>{pitch[0] * whole_of(of, c), pitch[1] * whole_of(of, c + 1), pitch[2] * whole_of(of, c + 2)};
        };
        const auto share = [&](int c) {
            return Vector3<Lanes>{single_of(of, c), single_of(of, c + 1), single_of(of, c + 2)};
        };
        return {lever(0), lever(3), share(6), share(9)};
    }
    BONDEM_INLINE CrackSoftening<Lanes> softening(const CohesiveCracks &cracks) const {
        const Row<Lanes> of = lines(cracks.softening);
        const auto h = [&](int c) { return single_of(of, c); };
        const Lanes *const c = of.column;
        return {{h(0), h(1), h(2), h(3), h(4), h(5)}, h(6), c[4], c[5], c[6], c[7]};
    }
    // Mask of the cracks of a group with a flag.
    BONDEM_INLINE Mask<Lanes> flagged(const Array<Byte, 1> &flag) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = flag.data[e + n];
        if (known < lanes)
            for (int n = known; n < lanes; n++) all[n] = all[known - 1];
        return all > Lanes{};
    }
    // Writes a flag at the places whose mask is set; if any is set, the number of their portion becomes `as`.
    void flag(const Array<Byte, 1> &to, const Array<Index, 1> &of_portions, Index portion, Mask<Lanes> where, Byte value,
              Index as = 1) const {
        if (!any(where)) return;
        for (int n = 0; n < known; n++)
            if (where[n] != 0) to(e + n) = value;
        of_portions(portion) = as;
    }
    // Writes eight columns of both halves of each crack, from column `from` on.
    BONDEM_INLINE void put_halves(const CrackLists &lists, const Row<Lanes> &on_i, const Row<Lanes> &on_j,
                                  Index from = 0) const {
        double *i[lanes], *j[lanes];
        for (int n = 0; n < lanes; n++) {
            i[n] = lists.half.data + 16 * half_of(crack[n], 0) + from;
            j[n] = i[n] + 16;
        }
        scatter_rows(i, on_i);
        scatter_rows(j, on_j);
    }
    // Calls on(crack, place, lane) for the lanes of a group whose mask is set.
    template <class On> BONDEM_INLINE void where(Mask<Lanes> mask, On on) const {
        for (int n = 0; n < known; n++)
            if (mask[n] != 0) on(crack[n], e + n, n);
    }
    static BONDEM_INLINE double lane(Lanes a, int n) { return a[n]; }
    BONDEM_INLINE void add(Lanes a, ExactSum &total) const {
        if (any(a != Lanes{}))
            for (int n = 0; n < known; n++) total.add(a[n]);
    }

  private:
    static BONDEM_INLINE void ask(const Array<double, 2> &rows, Index k) { bondem::prefetch(rows.data + 8 * k); }
    static BONDEM_INLINE void ask(const CohesiveCracks &cracks, Index k) { bondem::prefetch(cracks.pull.data + 4 * k); }
    static BONDEM_INLINE void ask(const CrackLists &lists, Index k) {
        for (int line = 0; line < 4; line++) bondem::prefetch(lists.half.data + 16 * half_of(k, 0) + 8 * line);
    }
};

// ---- lists

// Calls on(first, last, portion) for the portions of a list of `count` places, on the threads of a range.
template <class On> inline void over_places(const Range &range, Index count, On on) {
    for_each_task(range.threads, portions(count, crack::of_portion), [&](Index task) {
        const Index first = task * crack::of_portion;
        on(first, least(first + crack::of_portion, count), task);
    });
}
// Calls on(group) for the groups of places first … last - 1 of the list of `count` active cracks.
template <class On> BONDEM_INLINE void for_each_group_of(const CrackLists &lists, Index first, Index last, Index count, On on) {
    for (Index e = first; e < last; e += lanes) on(CrackGroup{lists.treated, lists.treated_i, lists.treated_j, e, count});
}
#endif

}  // namespace bondem
