// CohesiveCracks as passes read them: as many as there are lanes, from rows by number and from columns by place.
#pragma once
#include "../../laws/crack.hpp"
#include "../../laws/softening.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../threads.hpp"
#include "../cells/facets.hpp"

namespace bondem {

// Columns of a row: facet, strength [Pa] (0 where a cell had no cohesion), slip in the frame of cell i [m], -∂U/∂s [J],
// how the crack is treated, integrity a step ago; friction force a step ago [N], energy dissipated [J], force below which
// it does not soften [N] (once faces have parted, the distance of centres at which cells touch [m]), integrity.
namespace crack {
enum Column : int { facet, strength, slip, rate = 5, status, before, rub, spent = 11, top, integrity };
constexpr int row_width = 16, constant_width = 40;
// How a crack is treated: one by one; as a facet of less stiffness; not at all, as its faces have parted.
enum Status : int { active, resting, parted };
// What becomes of a crack in a step, besides nothing.
enum Flag : Byte { unchanged, fell, calmed, parts, wakes };
// Stands for the integrity a step ago of a crack that begins.
constexpr double fresh = 2.0;
// Places of a portion of a list.
constexpr Index of_portion = 256;
}  // namespace crack

// Rows of a table, a lane each.
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

// CohesiveCracks of a list from place e on.
struct CrackGroup {
    Index e;
    int known;  // how many there are; lanes behind repeat one, and are not written
    const Index *crack;
    const Short *i, *j;

    CrackGroup(const Array<Index, 1> &list, const Array<Short, 1> &at_i, const Array<Short, 1> &at_j, Index e, Index count)
        : e(e), known(int(least(count - e, Index(lanes)))), crack(list.data + e), i(at_i.data + e), j(at_j.data + e) {}

    // Eight columns of the rows of a table of so many columns.
    BONDEM_INLINE Row<Lanes> columns(const Array<double, 2> &table, int width, int first) const {
        const double *row[lanes];
        for (int n = 0; n < lanes; n++) row[n] = table.data + width * crack[n] + first;
        return gather_rows(row);
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, int width, int first, const Row<Lanes> &all) const {
        double *row[lanes], unused[8];
        for (int n = 0; n < lanes; n++) row[n] = n < known ? table.data + width * crack[n] + first : unused;
        scatter_rows(row, all);
    }
    BONDEM_INLINE Lanes number(const Array<double, 2> &table, int width, int column) const {
        Lanes all;
        for (int n = 0; n < lanes; n++) all[n] = table.data[width * crack[n] + column];
        return all;
    }
    BONDEM_INLINE void put(const Array<double, 2> &table, int width, int column, Lanes all) const {
        for (int n = 0; n < known; n++) table.data[width * crack[n] + column] = all[n];
    }
    BONDEM_INLINE Row<Lanes> state(const CohesiveCracks &cracks, int first) const {
        return columns(cracks.row, crack::row_width, first);
    }
};

// ---- constants of a crack: five groups of eight columns

struct CrackConstants {
    FacetShape<Lanes> shape;
    FacetCompliance<Lanes> facet;
    Lanes area, friction;
};
BONDEM_INLINE CrackConstants constants_of(const CrackGroup &group, const CohesiveCracks &cracks) {
    const Row<Lanes> on_i = group.columns(cracks.constant, crack::constant_width, 0);
    const Row<Lanes> on_j = group.columns(cracks.constant, crack::constant_width, 8);
    const Lanes *const a = on_i.column, *const b = on_j.column;
    return {{{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {a[3], a[4], a[5]}, {b[3], b[4], b[5]}}, {a[6], a[7]}, b[6], b[7]};
}
struct CrackJudgement {
    Vector3<Lanes> normal;
    Lanes bends, k, area, brittleness, fastest;
    Symmetric3<Lanes> H;
    Lanes plane;
};
BONDEM_INLINE CrackJudgement judgement_of(const CrackGroup &group, const CohesiveCracks &cracks) {
    const Row<Lanes> a = group.columns(cracks.constant, crack::constant_width, 16);
    const Row<Lanes> b = group.columns(cracks.constant, crack::constant_width, 24);
    const Lanes *const p = a.column, *const q = b.column;
    return {{p[0], p[1], p[2]}, p[3], p[4], p[5], p[6], p[7], {q[0], q[1], q[2], q[3], q[4], q[5]}, q[6]};
}
BONDEM_INLINE CrackStrength<Lanes> strength_of(const CrackGroup &group, const CohesiveCracks &cracks, const CrackJudgement &of,
                                               Lanes strength) {
    const Mask<Lanes> on_plane = of.plane > all<Lanes>(0.5);
    PlaneStrength<Lanes> plane = {all<Lanes>(infinity), Lanes{}, Lanes{}};
    if (any(on_plane)) {
        const Row<Lanes> more = group.columns(cracks.constant, crack::constant_width, 32);
        plane = {more.column[0], more.column[1], more.column[2]};
    }
    return {{strength, of.brittleness}, plane, on_plane};
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

// ---- what is known of a crack in a step, by place

BONDEM_INLINE void put_measured(const CrackLists &lists, Index e, const CrackFaces<Lanes> &at) {
    double *const to = lists.measured.data + e;
    const Index pitch = lists.measured.shape[1];
    const Vector3<Lanes> rows[7] = {at.gap, at.normal, at.share_i, at.share_j, at.arm_i, at.arm_j, at.normal_i};
    for (int r = 0; r < 7; r++) {
        store(to + (3 * r) * pitch, rows[r].x);
        store(to + (3 * r + 1) * pitch, rows[r].y);
        store(to + (3 * r + 2) * pitch, rows[r].z);
    }
}
BONDEM_INLINE Vector3<Lanes> measured_row(const CrackLists &lists, Index e, int r) {
    const double *const from = lists.measured.data + e;
    const Index pitch = lists.measured.shape[1];
    return {load(from + 3 * r * pitch), load(from + (3 * r + 1) * pitch), load(from + (3 * r + 2) * pitch)};
}
BONDEM_INLINE CrackFaces<Lanes> measured_faces(const CrackLists &lists, Index e) {
    return {measured_row(lists, e, 0), measured_row(lists, e, 1), measured_row(lists, e, 2), measured_row(lists, e, 3),
            measured_row(lists, e, 4), measured_row(lists, e, 5), measured_row(lists, e, 6)};
}
template <class T> BONDEM_INLINE Row<T> row_of(const SwellingHalf<T> &half) {
    return {{half.swollen, half.pulled, half.square, half.along, half.pressed, half.closed, half.loose, half.turns}};
}
BONDEM_INLINE SwellingHalf<Lanes> half_of(const Row<Lanes> &row) {
    const Lanes *const c = row.column;
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
}
// Writes rows of both halves of the cracks of a group.
BONDEM_INLINE void put_halves(double *table, Index e, const Row<Lanes> &on_i, const Row<Lanes> &on_j) {
    double *i[lanes], *j[lanes];
    for (int n = 0; n < lanes; n++) {
        i[n] = table + 8 * (2 * (e + n) + 1);
        j[n] = i[n] + 8;
    }
    scatter_rows(i, on_i);
    scatter_rows(j, on_j);
}

BONDEM_INLINE Lanes stress_at(const Array<double, 2> &pose, const Short *cell) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = pose.data[8 * uint64_t(cell[n]) + stress_column];
    return all;
}
// Calls on(first, last, portion) for portions of a list of so many places, on the threads of a turn.
template <class On> inline void over_places(const Turn &turn, Index count, On on) {
    for_each_task(turn.threads, portions(count, crack::of_portion), [&](Index task) {
        const Index first = task * crack::of_portion;
        on(first, least(first + crack::of_portion, count), task);
    });
}
// Whether each lane has a flag.
BONDEM_INLINE Mask<Lanes> flagged(const Byte *flag) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = flag[n];
    return all > Lanes{};
}

}  // namespace bondem
