// Access of passes to bonds of the non-local law and to stresses of elements, for one or for one per SIMD lane.
#pragma once
#include "../../laws/non_local.hpp"
#include "../../select.hpp"
#include "../../tables/non_local_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// First columns of the stored values of a bond, and of its loads.
enum Stored : Index { gap_column, extra_column = 3, taken_column = 6 };
enum Output : Index { force_column, on_i_column = 3, on_j_column = 6 };

template <class T> BONDEM_INLINE PairShape<T> pair_shape(const NonLocalBonds &bonds, Index k) {
    const Index m = bonds.normal.shape[1];
    return {vector_at<T>(bonds.normal.data, m, 0, k), vector_at<T>(bonds.lever_i.data, m, 0, k),
            vector_at<T>(bonds.lever_j.data, m, 0, k)};
}
template <class T> BONDEM_INLINE PairStiffness<T> pair_stiffness(const NonLocalBonds &bonds, Index k) {
    return {number<T>(bonds.area.data, k), number<T>(bonds.kn.data, k), number<T>(bonds.kt.data, k)};
}
inline PairLaw pair_law(const NonLocalBonds &bonds) { return {bonds.nu, bonds.limited != 0}; }
inline PairPose<double> pair_pose(const double *pose, const Beams &beams, const NonLocalBonds &bonds, Index k) {
    const Ends<double> ends = ends_of(pose, beams, k);
    return pair_pose(ends.branch, matrix_of(ends.i), ends.j, pair_shape<double>(bonds, k));
}

template <class T> BONDEM_INLINE PairStore<T> stored_by(const NonLocalBonds &bonds, Index k) {
    const double *const data = bonds.history.data;
    const Index m = bonds.history.shape[1];
    return {vector_at<T>(data, m, gap_column, k), vector_at<T>(data, m, extra_column, k),
            number<T>(data + taken_column * m, k)};
}
// The present extra force. `mean()` returns the mean stress of both elements a step ago; a step of zero duration
// (`steps` is false) does not call it, and keeps the extra force.
template <bool steps, class T, class Mean>
BONDEM_INLINE Vector3<T> extra_now(const PairStore<T> &before, const PairPose<T> &now, const Rotation<T> &i,
                                   const PairStiffness<T> &stiffness, const PairLaw &law, Mean mean) {
    if constexpr (steps)
        return extra_after(before, mean(), now, i, stiffness, law);
    else
        return turned_by(i, before.extra);
}
// The values that a bond stores after the step.
template <bool steps, class T>
BONDEM_INLINE PairStore<T> store_now(const PairStore<T> &before, Vector3<T> extra, const PairPose<T> &now,
                                     const Rotation<T> &i, T s) {
    if constexpr (steps)
        return store_after(before, extra, now, i, s);
    else
        return {turned_by(inverse(i), now.gap), before.extra, before.taken};
}
// Writes the stored values of bonds of integrity s; those of broken bonds do not change.
template <class Place, class T>
BONDEM_INLINE void keep_store(const NonLocalBonds &bonds, Place place, T s, const PairStore<T> &now,
                              const PairStore<T> &before) {
    double *const data = bonds.history.data;
    const Index m = bonds.history.shape[1];
    const Mask<T> unbroken = s > T{};
    keep_vector(data, m, gap_column, place, select(unbroken, now.gap, before.gap));
    keep_vector(data, m, extra_column, place, select(unbroken, now.extra, before.extra));
    keep_number(data + taken_column * m, place, now.taken);
}
template <class Place, class T>
BONDEM_INLINE void keep_output(const NonLocalBonds &bonds, Place place, const NonLocalLoads<T> &loads) {
    keep_loads(bonds.output.data, bonds.output.shape[1], place, loads);
}
inline Vector output_at(const NonLocalBonds &bonds, Output first, Index k) {
    return vector_at<double>(bonds.output.data, bonds.output.shape[1], first, k);
}

// The stress in a row of a table of stresses in space, or of their moments.
template <class T> BONDEM_INLINE Stress<T> stress_of(const Row<T> &row) {
    const T *c = row.column;
    return {c[0], c[1], c[2], c[3], c[4], c[5]};
}

}  // namespace bondem
