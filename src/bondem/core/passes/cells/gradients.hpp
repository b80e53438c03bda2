// Gradients of the dilatation at one cell, for passes of a step and for any poses.
//
// With σ = λ_p θ_p of the cells, springs between neighbours store ½ c (σ_i - σ_j)², so that the stress of a cell becomes
//
//     σ_p + λ_p / V_p Σ c (σ_p - σ_q)
//
// In a layer of normal n, V χ = Σ 2 v · (n × s) over the facets within the layer, with v the vector part of the relative
// rotation, and U = ½ J λ_p χ². With m = Σ τ n × s of both cells, τ = J λ_p χ / V, the torque on cell p is
//
//     R_p (w m + v × m)
//
// A wall does not rotate: with v of the rotation of the cell since the wall holds it, V χ has -2 v · (n × s) more, and the
// torque τ (w n × s + v × (n × s)).
#pragma once
#include "facets.hpp"
#include "walls.hpp"

namespace bondem {

// Σ c (σ_p - σ_q) of a cell [m³], by stresses `stress(q)`.
template <class Stress>
inline double difference_of(const DilatationGradients &gradients, Index p, Stress stress) {
    double sum = 0.0;
    const double own = stress(p);
    for (Index e = gradients.start(p); e < gradients.start(p + 1); e++)
        sum += gradients.spring(e) * (own - stress(Index(gradients.other(e))));
    return sum;
}

inline bool has_layers(const DilatationGradients &gradients) { return gradients.bend.size() > 0; }

// The rotation of the other cell of facet e of a layer relative to cell p: its cosine, and its vector in the frame of p.
struct LayerTurn {
    double w;
    Vector v;
};
inline LayerTurn positive(double w, Vector v) {
    const double sign = w < 0.0 ? -1.0 : 1.0;
    return {sign * w, sign * v};
}
inline LayerTurn layer_turn(const Array<double, 2> &pose, const DilatationGradients &gradients, Index p, Index e) {
    const Quaternion<double> own = orientation(gather(pose.data, Short(p)));
    const RelativeTurn<double> turn = relative_turn(own, orientation(gather(pose.data, gradients.next(e))));
    return positive(turn.w, turn.v);
}
// Rotation of cell p since the wall of entry e began to hold it, in space.
inline LayerTurn wall_turn(const Array<double, 2> &pose, const WallConstraints &walls,
                           const DilatationGradients &gradients, Index e) {
    const HeldTurn turn = held_turn(pose, walls, gradients.wall(e));
    return positive(turn.w, turn.v);
}
// n × s of one direction of facet e, of the cell itself (0, 1) or of the other (2, 3); and that of a wall.
inline Vector vector_of(const Array<const double, 2> &ways, Index e, Index which) {
    const double *way = &ways(e, 3 * which);
    return {way[0], way[1], way[2]};
}

inline void bend_cell(const Array<double, 2> &pose, const WallConstraints &walls, const DilatationGradients &gradients,
                      Index p) {
    double sum[2] = {};
    for (Index e = gradients.layer(p); e < gradients.layer(p + 1); e++) {
        const Vector v = layer_turn(pose, gradients, p, e).v;
        for (Index d = 0; d < 2; d++) sum[d] += 2.0 * dot(v, vector_of(gradients.way, e, d));
    }
    for (Index e = gradients.hold(p); e < gradients.hold(p + 1); e++) {
        const Vector v = wall_turn(pose, walls, gradients, e).v;
        for (Index d = 0; d < 2; d++) sum[d] -= 2.0 * dot(v, vector_of(gradients.wall_way, e, d));
    }
    for (Index d = 0; d < 2; d++) gradients.bend(p, d) = gradients.weight(p, d) * sum[d];
}
inline void twist_cell(const Array<double, 2> &pose, const WallConstraints &walls, const DilatationGradients &gradients,
                       Index p) {
    Vector sum = {};
    for (Index e = gradients.layer(p); e < gradients.layer(p + 1); e++) {
        const LayerTurn turn = layer_turn(pose, gradients, p, e);
        const Index q = gradients.next(e);
        Vector m = {};
        for (Index d = 0; d < 2; d++) {
            m = plus(m, gradients.bend(p, d), vector_of(gradients.way, e, d));
            m = plus(m, gradients.bend(q, d), vector_of(gradients.way, e, 2 + d));
        }
        sum = sum + plus_cross(turn.w * m, turn.v, m);
    }
    Vector torque = turned_by(orientation(gather(pose.data, Short(p))), sum);
    for (Index e = gradients.hold(p); e < gradients.hold(p + 1); e++) {
        const LayerTurn turn = wall_turn(pose, walls, gradients, e);
        Vector m = {};
        for (Index d = 0; d < 2; d++) m = plus(m, gradients.bend(p, d), vector_of(gradients.wall_way, e, d));
        torque = torque + plus_cross(turn.w * m, turn.v, m);
    }
    for (Index axis = 0; axis < 3; axis++) gradients.torque(p, axis) = torque[axis];
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
