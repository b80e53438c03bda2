// Loads of beams for a failure criterion. For one beam, also its index (1 at failure) and its mode of failure.
#pragma once
#include "../../laws/angles.hpp"
#include "../../laws/criteria/bond_criteria.hpp"
#include "../beams/bonds.hpp"
#include "pipeline.hpp"

namespace bondem {

// Angle between the axis e of a beam and that of an end [rad].
template <class T> BONDEM_INLINE T angle_at(Quaternion<T> end, Vector3<T> direction, Vector3<T> e) {
    const Vector3<T> own = rotate(end, direction);
    return angle_of(length(cross(own, e)), dot(own, e));
}

// Loads of a beam for a criterion, from its ends and forces; `station` is the place where its moment counts.
template <class Criterion, class T>
BONDEM_INLINE BondLoads<T> seen_loads(const Ends<T> &ends, const BeamShape<T> &shape, const BeamLoads<T> &loads, T station) {
    const T l = length(ends.branch), zero = {};
    const Vector3<T> e = ends.branch / l;
    // the moment at the contact point is that on i, and that of the force on j with the lever there
    const Vector3<T> at_contact = plus(loads.on_i, station * l, cross(e, loads.force));
    const T at_ends = most(length(cross(loads.on_i, e)), length(cross(loads.on_j, e)));
    const T bending = station < zero ? at_ends : length(cross(at_contact, e));
    T angle = {};
    if constexpr (Criterion::sees_angles)
        angle = most(angle_at(ends.i, shape.direction, e), angle_at(ends.j, shape.direction, e));
    return {-dot(loads.force, e), length(cross(loads.force, e)), bending,
            absolute(dot(loads.on_i, e)), l / shape.length - 1.0, angle};
}

// Index and mode of a criterion for one beam, with its ends and `strengths` (coefficients, and station).
template <class Criterion, class Strong>
inline Verdict<double> verdict_at(const Ends<double> &ends, const Beams &beams, const Strong &strengths, Index k) {
    const BeamShape<double> shape = shape_of<double>(beams, k);
    const BeamLoads<double> loads = beam_loads(ends, shape, stiffness_of(beams, k, beams.integrity(k)));
    return Criterion::verdict(seen_loads<Criterion>(ends, shape, loads, strengths.station(k)), coefficients_of(strengths, k));
}
template <class Criterion>
inline Verdict<double> verdict_of(const double *pose, const Beams &beams, const Strengths &strengths, Index k) {
    return verdict_at<Criterion>(ends_of(pose, beams, k), beams, strengths, k);
}

}  // namespace bondem
