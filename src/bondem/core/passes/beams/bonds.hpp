// Access to the bonds of a table (ends, constants, loads): of one bond, or of as many as a vector register has lanes.
#pragma once
#include "../../laws/beam.hpp"
#include "../motion/moved_poses.hpp"

namespace bondem {

// A branch over the nearest periodic image [m].
template <class T> BONDEM_INLINE Vector3<T> over_nearest_image(const Vector3<T> &d, const double *period) {
    return {over_nearest_image(d.x, period[0], period[3]), over_nearest_image(d.y, period[1], period[4]),
            over_nearest_image(d.z, period[2], period[5])};
}
template <class T> BONDEM_INLINE Vector3<T> branch(const Row<T> &i, const Row<T> &j, const double *period) {
    const Vector3<T> d = {j.column[0] - i.column[0], j.column[1] - i.column[1], j.column[2] - i.column[2]};
    return over_nearest_image(d, period);
}
template <class T> BONDEM_INLINE Ends<T> ends_of(const Row<T> &i, const Row<T> &j, const double *period) {
    return {branch(i, j, period), orientation(i), orientation(j)};
}

// Calls on(k, true if p is end i of bond k) for the bonds of element p, first those of which it is end j.
template <class Bonds, class On> BONDEM_INLINE void for_each_bond_of(const Bonds &of, Index p, On on) {
    for (Index k = of.in_start(p); k < of.in_start(p + 1); k++) on(k, false);
    for (Index e = of.out_start(p); e < of.out_start(p + 1); e++) on(Index(of.out_bond(e)), true);
}

#if defined(BONDEM_LANES)
template <class T> BONDEM_INLINE Ends<T> ends_of(const PairOfRows<T> &rows, const double *period) {
    return ends_of(rows.first, rows.second, period);
}
#endif

// The numbers of a column of one bond, or of the bonds from k on.
template <class T> BONDEM_INLINE T number(const double *column, Index k);
template <> BONDEM_INLINE double number<double>(const double *column, Index k) { return column[k]; }
#if defined(BONDEM_LANES)
template <> BONDEM_INLINE Lanes number<Lanes>(const double *column, Index k) { return load(column + k); }
template <> BONDEM_INLINE Dual<Lanes> number<Dual<Lanes>>(const double *column, Index k) { return load(column + k); }
#endif

// Three rows of numbers of a table (…, m), from row `first` on.
template <class T> BONDEM_INLINE Vector3<T> vector_at(const double *table, Index m, Index first, Index k) {
    const double *column = table + first * m + k;
    return {number<T>(column, 0), number<T>(column + m, 0), number<T>(column + 2 * m, 0)};
}

template <class T> BONDEM_INLINE Vector3<T> direction_of(const Beams &beams, Index k) {
    return {number<T>(beams.X0.data, k), number<T>(beams.Y0.data, k), number<T>(beams.Z0.data, k)};
}
template <class T> BONDEM_INLINE BeamShape<T> shape_of(const Beams &beams, Index k) {
    return {direction_of<T>(beams, k), number<T>(beams.length.data, k)};
}
// Constants of the energy times a factor, such as the integrity.
template <class T> BONDEM_INLINE BeamStiffness<T> stiffness_of(const Beams &beams, Index k, T share) {
    return {share * number<T>(beams.kn.data, k), share * number<T>(beams.A.data, k), share * number<T>(beams.B.data, k),
            share * number<T>(beams.C.data, k), share * number<T>(beams.kt.data, k)};
}
// Stiffness of beams with constants of their own (`Own`), or with shared ones divided by their length (`Uniform`).
struct Own {
    const Beams &beams;
    template <class T> BONDEM_INLINE BeamStiffness<T> stiffness(Index k) const {
        return stiffness_of(beams, k, number<T>(beams.integrity.data, k));
    }
};
struct Uniform {
    const double *per_length;
    double kn, A, B, kt;
    template <class T> BONDEM_INLINE BeamStiffness<T> stiffness(Index k) const {
        const T h = number<T>(per_length, k);
        return {kn * h, A * h, B * h, A * h, kt * h};
    }
};
inline Uniform all_uniform(const UniformBeams &by) { return {by.per_length.data, by.knL, by.AL, by.BL, by.ktL}; }

template <class Bonds> inline Ends<double> ends_of(const double *pose, const Bonds &bonds, Index k) {
    return ends_of(gather(pose, bonds.i(k)), gather(pose, bonds.j(k)), bonds.period.data);
}

// Writes a number of one bond, or of the bonds of a group, but not of those of the group before.
BONDEM_INLINE void keep_number(double *column, Index k, double a) { column[k] = a; }
#if defined(BONDEM_LANES)
// A group of as many bonds as there are lanes.
struct Group {
    Index first;
    int known;  // number of its bonds that belong to the group before
};
BONDEM_INLINE void keep_number(double *column, Group group, Lanes a) {
    store_behind(column + group.first, a, group.known);
}
#endif
template <class Place, class T>
BONDEM_INLINE void keep_vector(double *table, Index m, Index first, Place place, Vector3<T> a) {
    for (Index c = 0; c < 3; c++) keep_number(table + (first + c) * m, place, a[c]);
}
// Writes the force and the torques of a bond to rows of a table (9, m).
template <class Place, class Loads>
BONDEM_INLINE void keep_loads(double *table, Index m, Place place, const Loads &loads) {
    keep_vector(table, m, 0, place, loads.force);
    keep_vector(table, m, 3, place, loads.on_i);
    keep_vector(table, m, 6, place, loads.on_j);
}

#if defined(BONDEM_LANES)

// Adds force and torques of lanes from `known` on to the sums of both ends of their bonds; for duals, derivatives.
template <class Loads>
BONDEM_INLINE void add_loads_of(double *sums, const Short *row_i, const Short *row_j, const Loads &loads, int known) {
    const Vector3<Lanes> f = written(loads.force), a = written(loads.on_i), b = written(loads.on_j);
    const Lanes zero = {};
    add_rows(sums, row_i, row_j, {{-f.x, -f.y, -f.z, zero, a.x, a.y, a.z, zero}}, {{f.x, f.y, f.z, zero, b.x, b.y, b.z, zero}},
             known);
}
// Calls on(group) for the groups of the bonds first … last - 1. The last group is moved back to end with the last
// bond, so that every group is read as a whole. Tables contain at least one group; entries after fewer
// bonds have no effect.
template <class On> BONDEM_INLINE void for_each_group(Index first, Index last, On on) {
    for (Index k = first; k < last; k += lanes) {
        if (k + lanes <= last || last < lanes)
            on(Group{k, 0});
        else
            on(Group{last - lanes, int(k + lanes - last)});
    }
}

#endif

}  // namespace bondem
