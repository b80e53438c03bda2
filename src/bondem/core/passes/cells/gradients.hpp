// Gradients of the dilatation at one cell, in a step and in given poses, with the symbols of `laws/cell.hpp`.
//
// Springs with a constant c between neighbouring cells p and q store ½ c (σ_p - σ_q)² with σ = λ_p θ_p. These springs
// change the stress of a cell to
//
//     σ_p + λ_p / V_p Σ c (σ_p - σ_q)
//
// A layer one cell thick, with the normal n, resists bending. The curvature χ of a cell in the layer follows from V
// χ = Σ 2 v · (n × s), summed over its facets within the layer. The energy of the cell is U = ½ J λ_p χ², with the
// second moment of volume J along n. w and v are the scalar and the vector part of the rotation of the neighbour
// relative to the cell. With τ = J λ_p χ / V, and m = Σ τ n × s of both cells of a facet, the torque on cell p is
//
//     R_p (w m + v × m)
//
// A wall does not rotate. Let w and v be those of the rotation of the cell since the wall began to fix it. Then the
// wall adds -2 v · (n × s) to V χ, and the torque τ (w n × s + v × (n × s)) to that of the cell.
#pragma once
#include "facets.hpp"
#include "walls.hpp"

namespace bondem {

// Sum Σ c (σ_p - σ_q) over the neighbours of a cell [m³], by stresses `stress(q)`.
template <class Stress>
inline double difference_of(const DilatationGradients &gradients, Index p, Stress stress) {
    double sum = 0.0;
    const double own = stress(p);
    for (Index e = gradients.start(p); e < gradients.start(p + 1); e++)
        sum += gradients.spring(e) * (own - stress(Index(gradients.other(e))));
    return sum;
}

inline bool has_layers(const DilatationGradients &gradients) { return gradients.bend.size() > 0; }

// A rotation by the quaternion with a scalar part of at least zero.
template <class T> CellTurn<T> positive(T w, Vector3<T> v) {
    const T sign = w < 0.0 ? -1.0 : 1.0;
    return {sign * w, sign * v};
}
// Rotation of the other cell of facet e of a layer relative to cell p: its cosine, and its vector in the frame of p.
template <class Pose>
inline CellTurn<NumberOf<Pose>> layer_turn(const Pose &pose, const DilatationGradients &gradients, Index p, Index e) {
    const auto own = orientation(gather(pose, Short(p)));
    const auto turn = relative_turn(own, orientation(gather(pose, gradients.next(e))));
    return positive(turn.w, turn.v);
}
// Rotation of cell p since the wall of entry e began to fix it, in space.
template <class Pose>
inline CellTurn<NumberOf<Pose>> wall_turn(const Pose &pose, const WallConstraints &walls,
                                          const DilatationGradients &gradients, Index e) {
    const auto turn = support_turn(pose, walls, gradients.wall(e));
    return positive(turn.w, turn.v);
}
// n × s of one direction of facet e, of the cell itself (0, 1) or of the other (2, 3), or of a wall (0, 1).
template <class T> inline Vector3<T> vector_of(const Array<const double, 2> &ways, Index e, Index which) {
    const double *way = &ways(e, 3 * which);
    return {way[0], way[1], way[2]};
}

// J λ χ / V of cell p in direction d, or a dual of it.
template <class T> inline T bend_of(const DilatationGradients &gradients, Index p, Index d) { return gradients.bend(p, d); }
template <> inline Dual<double> bend_of(const DilatationGradients &gradients, Index p, Index d) {
    return {gradients.bend(p, d), gradients.bend(p, 2 + d)};
}

template <class Pose>
inline void bend_cell(const Pose &pose, const WallConstraints &walls, const DilatationGradients &gradients, Index p) {
    using T = NumberOf<Pose>;
    T sum[2] = {};
    for (Index e = gradients.layer(p); e < gradients.layer(p + 1); e++) {
        const Vector3<T> v = layer_turn(pose, gradients, p, e).v;
        for (Index d = 0; d < 2; d++) sum[d] = sum[d] + 2.0 * dot(v, vector_of<T>(gradients.way, e, d));
    }
    for (Index e = gradients.wall_start(p); e < gradients.wall_start(p + 1); e++) {
        const Vector3<T> v = wall_turn(pose, walls, gradients, e).v;
        for (Index d = 0; d < 2; d++) sum[d] = sum[d] - 2.0 * dot(v, vector_of<T>(gradients.wall_way, e, d));
    }
    const Index column = sizeof(T) > sizeof(double) ? 2 : 0;  // changes are behind the values
    for (Index d = 0; d < 2; d++) gradients.bend(p, column + d) = written(gradients.weight(p, d) * sum[d]);
}
template <class Pose>
inline void twist_cell(const Pose &pose, const WallConstraints &walls, const DilatationGradients &gradients, Index p) {
    using T = NumberOf<Pose>;
    Vector3<T> sum = {};
    for (Index e = gradients.layer(p); e < gradients.layer(p + 1); e++) {
        const CellTurn<T> turn = layer_turn(pose, gradients, p, e);
        const Index q = gradients.next(e);
        Vector3<T> m = {};
        for (Index d = 0; d < 2; d++) {
            m = plus(m, bend_of<T>(gradients, p, d), vector_of<T>(gradients.way, e, d));
            m = plus(m, bend_of<T>(gradients, q, d), vector_of<T>(gradients.way, e, 2 + d));
        }
        sum = sum + plus_cross(turn.w * m, turn.v, m);
    }
    Vector3<T> torque = turned_by(orientation(gather(pose, Short(p))), sum);
    for (Index e = gradients.wall_start(p); e < gradients.wall_start(p + 1); e++) {
        const CellTurn<T> turn = wall_turn(pose, walls, gradients, e);
        Vector3<T> m = {};
        for (Index d = 0; d < 2; d++) m = plus(m, bend_of<T>(gradients, p, d), vector_of<T>(gradients.wall_way, e, d));
        torque = torque + plus_cross(turn.w * m, turn.v, m);
    }
    for (Index axis = 0; axis < 3; axis++) gradients.torque(p, axis) = written(torque[axis]);
}

// Energy of the springs of a cell, half of each, and of its bending [J]; the dilatation is that in `cells`.
inline double energy_of_gradients(const Array<double, 2> &pose, const CellDilatation &cells,
                                  const WallConstraints &walls, const DilatationGradients &gradients, Index p) {
    const auto stress = [&](Index q) { return cells.weight(q) * (cells.swelling(q) + cells.given(q)); };
    double sum = 0.5 * stress(p) * difference_of(gradients, p, stress);
    if (!has_layers(gradients)) return sum;
    bend_cell(pose, walls, gradients, p);
    for (Index d = 0; d < 2; d++)
        if (gradients.weight(p, d) > 0.0) sum += 0.5 * gradients.bend(p, d) * gradients.bend(p, d) / gradients.weight(p, d);
    return sum;
}

}  // namespace bondem
