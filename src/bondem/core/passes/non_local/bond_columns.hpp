// How passes read bonds of the non-local law, and stresses of elements: one, or as many as there are lanes.
#pragma once
#include "../../laws/non_local.hpp"
#include "../../tables/non_local_tables.hpp"
#include "../beams/bonds.hpp"

namespace bondem {

// First columns of what a bond stores, and of what it does.
enum Stored : Index { gap_column, extra_column = 3, taken_column = 6 };
enum Output : Index { force_column, on_i_column = 3, on_j_column = 6 };

// Three columns of numbers of a table (…, m), from column `first` on.
template <class T> BONDEM_INLINE Vector3<T> vector_at(const double *table, Index m, Index first, Index k) {
    const double *column = table + first * m + k;
    return {number<T>(column, 0), number<T>(column + m, 0), number<T>(column + 2 * m, 0)};
}
// Writes them for the bonds of a group, but not for those of the group before.
BONDEM_INLINE void keep_vector(double *table, Index m, Index first, Group group, Vector3<Lanes> a) {
    for (Index c = 0; c < 3; c++) store_behind(table + (first + c) * m + group.first, a[c], group.known);
}

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
    return pair_pose(ends.branch, ends.i, ends.j, pair_shape<double>(bonds, k));
}

// The stress in a row of a table of stresses in space, or of their moments.
template <class T> BONDEM_INLINE Stress<T> stress_of(const Row<T> &row) {
    const T *c = row.column;
    return {c[0], c[1], c[2], c[3], c[4], c[5]};
}

}  // namespace bondem
