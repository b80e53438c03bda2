// Cracks as passes read and write them: one, or as many as there are lanes. What becomes of them is written once, of
// either (`crack_places.hpp` and others).
#pragma once
#include "../../threads.hpp"
#include "../cells/facets.hpp"
#include "crack_rows.hpp"

namespace bondem {

// The facet of crack k in the reference.
BONDEM_INLINE FacetShape<double> facet_shape(const CohesiveCracks &cracks, Index k) {
    const CrackShapeRow &of = shape_of(cracks, k);
    const double *const pitch = cracks.pitch.data;
    const auto lever = [&](const int32_t *b) {
        return Vector{pitch[0] * double(b[0]), pitch[1] * double(b[1]), pitch[2] * double(b[2])};
    };
    const auto share = [](const float *g) { return Vector{double(g[0]), double(g[1]), double(g[2])}; };
    return {lever(of.lever_i), lever(of.lever_j), share(of.share_i), share(of.share_j)};
}

// The crack of facet k, whose place in a list is that of its facet.
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
    BONDEM_INLINE double pull(const CohesiveCracks &cracks, int d) const { return cracks.pull(crack, d); }
    BONDEM_INLINE void prefetch(const Array<double, 2> &) const {}
    BONDEM_INLINE void prefetch_pull(const CohesiveCracks &) const {}
    BONDEM_INLINE FacetShape<double> shapes(const CohesiveCracks &cracks) const { return facet_shape(cracks, crack); }
    BONDEM_INLINE Symmetric3<double> resistances(const CohesiveCracks &cracks, double *plane) const {
        const CrackSofteningRow &of = softening_of(cracks, crack);
        *plane = of.plane;
        return {of.H[0], of.H[1], of.H[2], of.H[3], of.H[4], of.H[5]};
    }
    BONDEM_INLINE bool flagged(const Array<Byte, 1> &flag) const { return flag(e) != 0; }
    BONDEM_INLINE void flag(const Array<Byte, 1> &to, const Array<Index, 1> &, Index, bool where, Byte value,
                            Index = 1) const {
        if (where) to(e) = value;
    }
    BONDEM_INLINE void put_halves(const Array<double, 2> &table, const Row<double> &on_i, const Row<double> &on_j,
                                  Index from = 0) const {
        *reinterpret_cast<Row<double> *>(&table(2 * e + 1, from)) = on_i;
        *reinterpret_cast<Row<double> *>(&table(2 * e + 2, from)) = on_j;
    }
    // Calls on(crack, place, lane) where a mask says so.
    template <class On> BONDEM_INLINE void where(bool mask, On on) const {
        if (mask) on(crack, e, 0);
    }
    static BONDEM_INLINE double lane(double a, int) { return a; }
    static BONDEM_INLINE void add(double a, double &total) { total += a; }
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

// Four columns of rows.
struct FourColumns {
    Lanes column[4];
};
// Of numbers of four bytes that `widen` makes numbers of eight of.
template <class Widen> BONDEM_INLINE FourColumns gather_four(const char *const *row, Widen widen) {
    FourColumns all;
    for (int half = 0; half < lanes; half += 4) {
        Four r[4];
        for (int n = 0; n < 4; n++) r[n] = widen(row[half + n]);
        transpose_four(r);
        for (int c = 0; c < 4; c++)
            for (int n = 0; n < 4; n++) all.column[c][half + n] = r[c][n];
    }
    return all;
}
typedef int32_t FourWhole __attribute__((vector_size(16), aligned(4)));
typedef float FourSingle __attribute__((vector_size(16), aligned(4)));
BONDEM_INLINE Four widened_whole(const char *from) {
    return __builtin_convertvector(*reinterpret_cast<const FourWhole *>(from), Four);
}
BONDEM_INLINE Four widened_single(const char *from) {
    return __builtin_convertvector(*reinterpret_cast<const FourSingle *>(from), Four);
}

// ---- a group of cracks

// Cracks of a list from place e on.
struct CrackGroup {
    using Number = Lanes;
    Index e;
    int known;  // how many there are; lanes behind repeat one, and are not written
    const Index *crack;
    const Short *i, *j;

    CrackGroup(const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index e,
               Index count)
        : e(e), known(int(least(count - e, Index(lanes)))), crack(list.data + e), i(at_i.data + e),
            j(at_j.data + e) {}

    // Lines of a table.
    BONDEM_INLINE Row<Lanes> lines(const Array<double, 2> &table) const {
        const double *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = table.data + 8 * crack[n];
        return gather_rows(row);
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, const Row<Lanes> &all) const {
        double *row[lanes], unused[8];
        for (int n = 0; n < lanes; n++) row[n] = n < known ? table.data + 8 * crack[n] : unused;
        scatter_rows(row, all);
    }
    // A number of each.
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
    // A component of the force on their cell i.
    BONDEM_INLINE Lanes pull(const CohesiveCracks &cracks, int d) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = cracks.pull.data[4 * crack[n] + d];
        return all;
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, int column, Lanes all) const {
        for (int n = 0; n < known; n++) table.data[8 * crack[n] + column] = all[n];
    }
    // Asks for the lines of a table that the crack some places later has.
    BONDEM_INLINE void prefetch(const Array<double, 2> &table) const {
        constexpr Index ahead = 24;
        for (int n = 0; n < known; n++) bondem::prefetch(table.data + 8 * crack[known == lanes ? ahead + n : 0]);
    }
    BONDEM_INLINE void prefetch_pull(const CohesiveCracks &cracks) const {
        constexpr Index ahead = 24;
        for (int n = 0; n < known; n++)
            bondem::prefetch(cracks.pull.data + 4 * crack[known == lanes ? ahead + n : 0]);
    }
    // The shape of their facets.
    BONDEM_INLINE FacetShape<Lanes> shapes(const CohesiveCracks &cracks) const {
        const char *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = reinterpret_cast<const char *>(cracks.shape.data + 8 * crack[n]);
        const FourColumns first = gather_four(row, widened_whole);
        const FourColumns middle = gather_four(row, [](const char *from) {
            return __builtin_shufflevector(widened_whole(from + 16), widened_single(from + 16), 0, 1, 6, 7);
        });
        const FourColumns last = gather_four(row, [](const char *from) { return widened_single(from + 32); });
        const double *const pitch = cracks.pitch.data;
        const Lanes *const a = first.column, *const b = middle.column, *const c = last.column;
        return {{pitch[0] * a[0], pitch[1] * a[1], pitch[2] * a[2]},
                {pitch[0] * a[3], pitch[1] * b[0], pitch[2] * b[1]}, {b[2], b[3], c[0]}, {c[1], c[2], c[3]}};
    }
    BONDEM_INLINE Symmetric3<Lanes> resistances(const CohesiveCracks &cracks, Lanes *plane) const {
        const char *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = reinterpret_cast<const char *>(cracks.softening.data + 8 * crack[n]);
        const FourColumns h = gather_four(row, widened_single);
        const FourColumns k = gather_four(row, [](const char *from) { return widened_single(from + 16); });
        *plane = k.column[2];
        return {h.column[0], h.column[1], h.column[2], h.column[3], k.column[0], k.column[1]};
    }
    // Which of them have a flag.
    BONDEM_INLINE Mask<Lanes> flagged(const Array<Byte, 1> &flag) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = flag.data[e + n];
        return all > Lanes{};
    }
    // Writes flags of known places.
    void flag(const Array<Byte, 1> &to, const Array<Index, 1> &of_portions, Index portion, Mask<Lanes> where, Byte value,
              Index as = 1) const {
        if (!any(where)) return;
        for (int n = 0; n < known; n++)
            if (where[n] != 0) to(e + n) = value;
        of_portions(portion) = as;
    }
    // Writes eight columns of both halves.
    BONDEM_INLINE void put_halves(const Array<double, 2> &table, const Row<Lanes> &on_i, const Row<Lanes> &on_j,
                                  Index from = 0) const {
        double *i[lanes], *j[lanes];
        for (int n = 0; n < lanes; n++) {
            i[n] = table.data + table.shape[1] * (2 * (e + n) + 1) + from;
            j[n] = i[n] + table.shape[1];
        }
        scatter_rows(i, on_i);
        scatter_rows(j, on_j);
    }
    // Calls on(crack, place, lane) for those that a mask names.
    template <class On> BONDEM_INLINE void where(Mask<Lanes> mask, On on) const {
        for (int n = 0; n < known; n++)
            if (mask[n] != 0) on(crack[n], e + n, n);
    }
    static BONDEM_INLINE double lane(Lanes a, int n) { return a[n]; }
    BONDEM_INLINE void add(Lanes a, double &total) const {
        for (int n = 0; n < known; n++) total += a[n];
    }
};

// ---- lists

// Calls on(first, last, portion) for portions of a list of so many places, on the threads of a turn.
template <class On> inline void over_places(const Turn &turn, Index count, On on) {
    for_each_task(turn.threads, portions(count, crack::of_portion), [&](Index task) {
        const Index first = task * crack::of_portion;
        on(first, least(first + crack::of_portion, count), task);
    });
}
// Calls on(group, portion) for the groups of a list of so many cracks; `before(first, last, portion)` comes before.
template <class Before, class On>
inline void over_treated(const Turn &turn, const CrackLists &lists, Before before, On on) {
    const Index count = lists.size(0);
    over_places(turn, count, [&](Index first, Index last, Index portion) {
        before(first, last, portion);
        for (Index e = first; e < last; e += lanes)
            on(CrackGroup{lists.treated, lists.treated_i, lists.treated_j, e, count}, portion);
    });
}
#endif

}  // namespace bondem
