// A facet that a wall fixes or supports. Such a wall does not rotate, so that a gap is measured along fixed axes:
//
//     δ = P (wall - u)      V θ += s · δ      U = ½ k |δ|² + 2 v · H v
//     u = x + R b - (x + R b in the reference)
//
// `wall` is the displacement of the wall, u that of the centroid of the facet, and P projects on the fixed axes. x,
// R, b, s, H and V θ are as in `laws/cell.hpp`, for the half of the facet in its cell, with the stiffness
// k = 2 G A / d. v is the vector part of q q₀*, the rotation of the cell since the wall began to fix the facet. A
// wall that begins to fix a moved face starts at the place of the face: `base` has the displacement there, and q₀.
//
// A wall with friction μ fixes a facet along its face while |f_t| ≤ μ N, with the shear force f_t and the compressive
// force N. Beyond this limit the facet slides: the wall moves with it until f_t is μ N, and the work
// ½ (f before + f after) · slip is lost to friction.
#pragma once
#include "../boundary/timeline.hpp"
#include "facets.hpp"

namespace bondem {

// A fixed facet in space: its gap, and its lever turned with the cell [m].
template <class T> struct SupportedFacet {
    Vector3<T> gap, arm;
};
template <class Pose>
inline SupportedFacet<NumberOf<Pose>> supported_facet(const Pose &pose, const Array<const double, 2> &rest,
                                                      const WallConstraints &walls, Index g) {
    using T = NumberOf<Pose>;
    const Index p = walls.cell(g);
    const Row<T> at = gather(pose, Short(p));
    const Vector3<T> arm = turned_by(orientation(at), constant<T>(walls.arm.row<const Vector>(g)));
    const auto gap = [&](Index axis) {
        const T moved = (at.column[axis] - rest(p, axis)) + (arm[axis] - walls.lever(g, axis));
        return walls.axes(g, axis) * (walls.wall(g, axis) - moved);
    };
    return {{gap(0), gap(1), gap(2)}, arm};
}

// The rotation q q₀* of a cell since its wall fixes it.
template <class T> struct CellTurn {
    T w;
    Vector3<T> v;
};
template <class Pose>
inline CellTurn<NumberOf<Pose>> support_turn(const Pose &pose, const WallConstraints &walls, Index g) {
    const auto q = orientation(gather(pose, Short(walls.cell(g))));
    const Quaternion<NumberOf<Pose>> o = {walls.base(g, 3), walls.base(g, 4), walls.base(g, 5), walls.base(g, 6)};
    return {relative_cosine(q, o), relative_sine(o, q)};
}

// Contribution of a wall to V θ of its cell [m³].
template <class Pose>
inline double dilatation_of_support(const Pose &pose, const Array<const double, 2> &rest, const WallConstraints &walls,
                                    Index g) {
    const auto share = constant<NumberOf<Pose>>(walls.share.row<const Vector>(g));
    return written(dot(share, supported_facet(pose, rest, walls, g).gap));
}

// Force of a wall on its cell, whose stress is known [N].
template <class Pose, class T>
inline Vector3<T> force_of_support(const Pose &pose, const WallConstraints &walls, Index g, const Vector3<T> &gap) {
    const T stress = gather(pose, Short(walls.cell(g))).column[stress_column];
    return plus(T(walls.k(g)) * gap, stress, constant<T>(walls.share.row<const Vector>(g)));
}

// Slides a facet on its wall beyond the limit of friction; returns the energy lost to friction [J].
inline double slide_support(const Array<double, 2> &pose, const Array<const double, 2> &rest,
                            const WallConstraints &walls, Index g) {
    const double friction = walls.friction(g);
    if (!(friction >= 0.0)) return 0.0;
    const Vector f = force_of_support(pose, walls, g, supported_facet(pose, rest, walls, g).gap);
    const Vector inward = walls.inward.row<const Vector>(g);
    const double pressing = dot(f, inward), limit = friction * positive(pressing);
    const Vector along = f - pressing * inward;
    const double size = length(along);
    if (size <= limit) return 0.0;
    const Vector slip = ((limit - size) / (size * walls.k(g))) * along;
    double lost = 0.0;
    for (Index axis = 0; axis < 3; axis++) {
        const double after = limit / size * along[axis] + pressing * inward[axis];
        lost -= 0.5 * (walls.load(g, axis) + after) * slip[axis];
        walls.wall(g, axis) += slip[axis];
        walls.base(g, axis) += slip[axis];
    }
    return lost;
}

// Sets force and torque of a wall on its cell, whose stress is known.
template <class Pose>
inline void load_support(const Pose &pose, const Array<const double, 2> &rest, const WallConstraints &walls, Index g) {
    using T = NumberOf<Pose>;
    const SupportedFacet<T> facet = supported_facet(pose, rest, walls, g);
    const Vector3<T> f = force_of_support(pose, walls, g, facet.gap);
    const CellTurn<T> turn = support_turn(pose, walls, g);
    const Vector3<T> h = constant<T>(walls.H.row<const Symmetric3<double>>(g)) * turn.v;
    const Vector3<T> torque = cross(facet.arm, f) - T(2.0) * plus(cross(turn.v, h), turn.w, h);
    for (Index axis = 0; axis < 3; axis++) {
        walls.load(g, axis) = written(f[axis]);
        walls.load(g, 3 + axis) = written(torque[axis]);
    }
}

// Sets the forces of walls on the rows of the boundary that their cells own.
inline void set_rows(const WallConstraints &walls, const Rows &rows) {
    for (Index r = 0; r < rows.support.size(); r++)
        for (Index c = 0; c < 6; c++) rows.support(r, c) = 0.0;
    for (Index g = 0; g < walls.cell.size(); g++)
        for (Index c = 0; c < 6; c++) rows.support(walls.row(g), c) += walls.load(g, c);
}

// Adds half the work of a wall that moves to the row of its cell.
inline void add_half_work(const WallConstraints &walls, const Rows &rows, Index g) {
    for (Index axis = 0; axis < 3; axis++)
        rows.work(walls.row(g)) += 0.5 * walls.load(g, axis) * walls.increment(g, axis);
}

// Energy of the half facet at a wall, without dilatation [J].
inline double energy_of_support(const Array<double, 2> &pose, const Array<const double, 2> &rest,
                                const WallConstraints &walls, Index g) {
    const Vector gap = supported_facet(pose, rest, walls, g).gap, v = support_turn(pose, walls, g).v;
    return 0.5 * walls.k(g) * dot(gap, gap) + 2.0 * dot(v, walls.H.row<const Symmetric3<double>>(g) * v);
}

// Moves the wall of a fixed facet to its place at a time, and stores its displacement in `increment`.
inline void place_support(const WallConstraints &walls, double time, Index g) {
    const Timeline timeline = {walls.times, walls.values, walls.start};
    for (Index axis = 0; axis < 3; axis++) {
        const Index s = walls.drive(g, axis);
        if (s < 0) continue;
        const double way = walls.rate(s) ? integral_to(timeline, s, time) : value_at(timeline, s, time);
        const double now = walls.base(g, axis) + way;
        walls.increment(g, axis) = now - walls.wall(g, axis);
        walls.wall(g, axis) = now;
    }
}

}  // namespace bondem
