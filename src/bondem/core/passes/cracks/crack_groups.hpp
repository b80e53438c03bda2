// Cracks as passes read them: as many as there are lanes.
#pragma once
#include "../../threads.hpp"
#include "../cells/facets.hpp"
#include "crack_rows.hpp"

namespace bondem {

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
    BONDEM_INLINE void put(const Array<double, 2> &table, int column, Lanes all) const {
        for (int n = 0; n < known; n++) table.data[8 * crack[n] + column] = all[n];
    }
    // Asks for the lines of a table that the crack some places later has.
    BONDEM_INLINE void prefetch(const Array<double, 2> &table) const {
        constexpr Index ahead = 24;
        for (int n = 0; n < known; n++) __builtin_prefetch(table.data + 8 * crack[known == lanes ? ahead + n : 0]);
    }
};

// The shape of the facets of a group.
BONDEM_INLINE FacetShape<Lanes> shapes_of(const CrackGroup &group, const CohesiveCracks &cracks) {
    const char *row[lanes];
    for (int n = 0; n < lanes; n++) row[n] = reinterpret_cast<const char *>(cracks.shape.data + 8 * group.crack[n]);
    const FourColumns first = gather_four(row, widened_whole);
    const FourColumns middle = gather_four(row, [](const char *from) {
        return __builtin_shufflevector(widened_whole(from + 16), widened_single(from + 16), 0, 1, 6, 7);
    });
    const FourColumns last = gather_four(row, [](const char *from) { return widened_single(from + 32); });
    const double *const pitch = cracks.pitch.data;
    const Lanes *const a = first.column, *const b = middle.column, *const c = last.column;
    return {{pitch[0] * a[0], pitch[1] * a[1], pitch[2] * a[2]}, {pitch[0] * a[3], pitch[1] * b[0], pitch[2] * b[1]},
            {b[2], b[3], c[0]}, {c[1], c[2], c[3]}};
}

// The faces of the cracks of a group, and what belongs to them.
struct CrackPlace {
    Ends<Lanes> ends;
    OfCells<Lanes> stress;  // of both cells [Pa]
    FacedFaces<Lanes> now;
    FacetCompliance<Lanes> facet;
    Lanes area, s, friction;
};
BONDEM_INLINE CrackPlace place_of(const CrackGroup &group, const Array<double, 2> &pose, const double *period,
                                  const CohesiveCracks &cracks) {
    group.prefetch(cracks.shape);
    group.prefetch(cracks.face);
    const Row<Lanes> a = gather(pose.data, group.i), b = gather(pose.data, group.j);
    const Ends<Lanes> ends = ends_of(a, b, period);
    const Row<Lanes> face = group.lines(cracks.face);
    const Lanes *const f = face.column;
    return {ends, {a.column[stress_column], b.column[stress_column]},
            crack_faces(ends, shapes_of(group, cracks), {f[0], f[1], f[2]}), {f[7], f[3]}, f[4], f[5], f[6]};
}

// How the cracks of a group soften.
struct CrackJudgement {
    Symmetric3<Lanes> H;
    Lanes bends, fastest;
    CrackStrength<Lanes> by;
};
BONDEM_INLINE Symmetric3<Lanes> resistances_of(const CrackGroup &group, const CohesiveCracks &cracks, Lanes *plane) {
    const char *row[lanes];
    for (int n = 0; n < lanes; n++) row[n] = reinterpret_cast<const char *>(cracks.softening.data + 8 * group.crack[n]);
    const FourColumns h = gather_four(row, widened_single);
    const FourColumns k = gather_four(row, [](const char *from) { return widened_single(from + 16); });
    *plane = k.column[2];
    return {h.column[0], h.column[1], h.column[2], h.column[3], k.column[0], k.column[1]};
}
BONDEM_INLINE CrackJudgement judgement_of(const CrackGroup &group, const CohesiveCracks &cracks) {
    group.prefetch(cracks.softening);
    Lanes plane;
    const Symmetric3<Lanes> H = resistances_of(group, cracks, &plane);
    const auto column = [&](int c) { return group.number(cracks.softening, c); };
    const Mask<Lanes> on_plane = plane > all<Lanes>(0.5);
    PlaneStrength<Lanes> more = {all<Lanes>(infinity), Lanes{}, Lanes{}};
    if (any(on_plane)) {
        const Row<Lanes> rows = group.lines(cracks.history);
        more = {rows.column[2], rows.column[3], rows.column[4]};
    }
    return {H, column(4), column(6), {{column(7), column(5)}, more, on_plane}};
}

// The mean stress of two cells.
BONDEM_INLINE Symmetric3<Lanes> mean_stress(const StressesOfCells &stresses, const Short *i, const Short *j) {
    const Row<Lanes> a = gather(stresses.tensor.data, i), b = gather(stresses.tensor.data, j);
    const auto mean = [&](int c) { return 0.5 * (a.column[c] + b.column[c]); };
    return {mean(0), mean(1), mean(2), mean(3), mean(4), mean(5)};
}
// A bound of what bending opens of a facet, without an angle: σ_3 is at most the least of the diagonal.
template <class T> BONDEM_INLINE T opened_at_most(T bent, const Symmetric3<T> &mean) {
    return positive(T(bent + least(least(least(mean.xx, mean.yy), mean.zz), T{})));
}

template <class T> BONDEM_INLINE Row<T> row_of(const SwellingHalf<T> &half) {
    return {{half.swollen, half.pulled, half.square, half.along, half.pressed, half.closed, half.loose, half.turns}};
}
BONDEM_INLINE SwellingHalf<Lanes> half_of(const Row<Lanes> &row) {
    const Lanes *const c = row.column;
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
}
// Writes rows of both halves of the cracks of a group.
BONDEM_INLINE void put_halves(double *table, const CrackGroup &group, const Row<Lanes> &on_i,
                              const Row<Lanes> &on_j) {
    double *i[lanes], *j[lanes];
    for (int n = 0; n < lanes; n++) {
        i[n] = table + 8 * (2 * (group.e + n) + 1);
        j[n] = i[n] + 8;
    }
    scatter_rows(i, on_i);
    scatter_rows(j, on_j);
}
template <class T> struct SwellingHalves {
    SwellingHalf<T> i, j;
};
template <class T>
BONDEM_INLINE SwellingHalves<T> swelling_halves(const FacetCompliance<T> &facet, T s, const CrackFaces<T> &at) {
    return {swelling_half(facet.k, facet.part, s, at.gap, at.share_i, at.normal),
            swelling_half(facet.k, T(1.0 - facet.part), s, at.gap, at.share_j, at.normal)};
}

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
// Whether each lane has a flag.
BONDEM_INLINE Mask<Lanes> flagged(const Byte *flag) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = flag[n];
    return all > Lanes{};
}
// Writes flags of the known places of a group.
inline void put_flags(const Array<Byte, 1> &flag, const Array<Index, 1> &flagged_portion, const CrackGroup &group,
                      Index portion, Mask<Lanes> where, Byte value) {
    if (!any(where)) return;
    for (int n = 0; n < group.known; n++)
        if (where[n] != 0) flag(group.e + n) = value;
    flagged_portion(portion) = 1;
}

}  // namespace bondem
