// Rows of tables of elements (pose, motion, sums), of one element or of as many as a vector register has lanes.
#pragma once
#include "../../lanes.hpp"
#include "../../laws/rotations.hpp"
#include "../../steps.hpp"

namespace bondem {

// Element number e of the list of a range.
struct One {
    using Number = double;
    Short element, row;

    One(const Range &range, Index e) : element(range.element[e]), row(range.row[e]) {}
    explicit One(Index element) : element(Short(element)), row(0) {}
};
BONDEM_INLINE Row<double> &row_at(double *table, Short place) {
    return *reinterpret_cast<Row<double> *>(table + 8 * uint64_t(place));
}
BONDEM_INLINE Row<double> gather(const double *table, const Short &place) {
    return *reinterpret_cast<const Row<double> *>(table + 8 * uint64_t(place));
}
BONDEM_INLINE Row<double> gather_sums(const double *table, const Short &first, const Short &second) {
    Row<double> sum = gather(table, first);
    for (int c = 0; c < 8; c++) sum.column[c] += table[8 * uint64_t(second) + c];
    return sum;
}
inline Vector centre(const double *pose, Short p) { return {pose[8 * uint64_t(p)], pose[8 * uint64_t(p) + 1], pose[8 * uint64_t(p) + 2]}; }
BONDEM_INLINE void scatter(double *table, const Short &place, const Row<double> &row) { row_at(table, place) = row; }
BONDEM_INLINE void clear(double *table, const Short &place) { row_at(table, place) = {}; }
// Numbers of a column of a table, one per element.
BONDEM_INLINE double number_at(const double *table, Index columns, Index c, const Short &place) {
    return table[columns * place + c];
}
BONDEM_INLINE void put_number(double *table, Index columns, Index c, const Short &place, double value) {
    table[columns * place + c] = value;
}

#if defined(BONDEM_LANES)

// The elements from number e of the list on; the last fills an incomplete group. All are read before one is written.
struct Several {
    using Number = Lanes;
    Short element[lanes], row[lanes];

    BONDEM_INLINE Several(const Range &range, Index e, Index last) {
        for (int n = 0; n < lanes; n++) {
            const Index place = least(e + n, last - 1);
            element[n] = range.element[place];
            row[n] = range.row[place];
        }
    }
};

BONDEM_INLINE void clear(double *table, const Short (&place)[lanes]) {
    for (int n = 0; n < lanes; n++) row_at(table, place[n]) = {};
}
BONDEM_INLINE Lanes number_at(const double *table, Index columns, Index c, const Short (&place)[lanes]) {
    Lanes all;
    for (int n = 0; n < lanes; n++) all[n] = table[columns * place[n] + c];
    return all;
}
BONDEM_INLINE void put_number(double *table, Index columns, Index c, const Short (&place)[lanes], Lanes value) {
    for (int n = 0; n < lanes; n++) table[columns * place[n] + c] = value[n];
}

#endif

// Velocities and inverse inertia in a row of the motion.
template <class T> struct Motion {
    Vector3<T> v;  // velocity [m/s]
    T m;  // 1/mass [1/kg]
    Vector3<T> w;  // angular velocity [rad/s]
    T u;  // 1/inertia [1/(kg m²)]

    explicit Motion(const Row<T> &row)
        : v{row.column[0], row.column[1], row.column[2]}, m(row.column[3]),
          w{row.column[4], row.column[5], row.column[6]}, u(row.column[7]) {}
    Row<T> row() const { return {{v.x, v.y, v.z, m, w.x, w.y, w.z, u}}; }
};
// Force and torque in a row of the sums.
template <class T> struct Wrench {
    Vector3<T> force, torque;  // [N, N·m]

    explicit Wrench(const Row<T> &row)
        : force{row.column[0], row.column[1], row.column[2]}, torque{row.column[4], row.column[5], row.column[6]} {}
};
template <class T> BONDEM_INLINE Quaternion<T> orientation(const Row<T> &pose) {
    return {pose.column[4], pose.column[5], pose.column[6], pose.column[7]};
}

// A row of the pose a step later: x += dt v + extra a, and the orientation by the exponential map.
template <class T>
BONDEM_INLINE Row<T> drifted(const Row<T> &pose, const Clock &clock, const Motion<T> &moving, Vector3<T> a, Vector3<T> b) {
    const double dt = clock.dt, extra = clock.extra;
    const Vector3<T> v = moving.v, w = moving.w;
    const Vector3<T> rotation = {extra * b.x + dt * w.x, extra * b.y + dt * w.y, extra * b.z + dt * w.z};
    const Quaternion<T> q = turned(orientation(pose), rotation);
    return {{pose.column[0] + (extra * a.x + dt * v.x), pose.column[1] + (extra * a.y + dt * v.y),
             pose.column[2] + (extra * a.z + dt * v.z), pose.column[3], q.w, q.x, q.y, q.z}};
}

}  // namespace bondem
