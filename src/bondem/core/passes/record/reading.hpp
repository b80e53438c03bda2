// Quantities of elements that gauges record.
#pragma once
#include "../../exact_sum.hpp"
#include "../motion/elements.hpp"

namespace bondem::gauge {

// Component of the rotation vector of a unit quaternion [rad], of length at most π.
inline double rotation_component(Quaternion<double> q, Index axis) {
    const Vector v = {q.x, q.y, q.z};
    const double sine = length(v);
    if (sine < 1e-12) return 2.0 * v[axis];
    return 2.0 * arc_tangent(sine, absolute(q.w)) * v[axis] / sine * (q.w >= 0.0 ? 1.0 : -1.0);
}

inline double read(const Moving &all, const Rows &rows, Index quantity, Index p, Index axis) {
    switch (quantity) {
        case gauge_quantity::displacement: return all.pose(p, axis) - all.rest(p, axis);
        case gauge_quantity::velocity: return all.motion(p, axis);
        case gauge_quantity::rotation: return rotation_component(orientation(gather(all.pose.data, Short(p))), axis);
        case gauge_quantity::angular_velocity: return all.motion(p, 4 + axis);
        default: break;
    }
    const Index r = rows.of(p);
    if (r < 0) return 0.0;
    const double of_walls = rows.support.size() > 0 ? rows.support(r, axis) : 0.0;  // on facets of the cell
    return of_walls + (rows.fixed(r, axis) ? rows.reaction(r, axis) : rows.force(r, axis));
}

// Sum and largest absolute value of the readings of a gauge.
struct Reading {
    ExactSum sum = {};
    double largest = -infinity;

    void add(double x) {
        sum.add(x);
        largest = most(largest, absolute(x));
    }
    double reduced(Index reduction, Index count) const {
        if (reduction == gauge_reduction::max_abs) return largest;
        return reduction == gauge_reduction::mean ? sum.value() / double(count) : sum.value();
    }
};

}  // namespace bondem::gauge
