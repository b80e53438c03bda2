// Rates of the dilatation θ, and the mass matrix with which short waves of pressure keep their speed.
//
// With the mass matrix M, waves of pressure are too slow at second order in their wave number. The matrix M' corrects
// this, with a factor β (`interactions/cells/corrected_mass.py`), the density ρ and the volumes V:
//
//     M' = M - Θᵀ (ρ V β) Θ        θ = Θ u for a small displacement u from the present pose
//
// An explicit step uses, under the loads F,
//
//     a = M⁻¹ (F + Θᵀ ρ V β Θ M⁻¹ F)
//
// which differs from M'⁻¹ F at fourth order in the wave number. Without walls, momentum is conserved, because the
// forces in each column of Θᵀ sum to zero.
#pragma once
#include "walls.hpp"

namespace bondem {

// Translational and rotational part of a velocity or an acceleration.
struct Rate {
    Vector linear, angular;
};

// Rate of V θ of cell p [m³/s or m³/s²] for rates `of(q)` of elements, with walls at rest.
template <class Of>
inline double dilatation_rate(const Array<double, 2> &pose, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass, Index p, Of of) {
    const FacetColumns columns(facets);
    double sum = 0.0;
    for_each_bond_of(mass, p, [&](Index k, bool is_i) {
        const Ends<double> ends = ends_of(pose.data, facets, k);
        const FacetShape<double> shape = columns.shape<double>(k);
        const OpenFacet<double> open = opened(ends, shape);
        const Rate i = of(Index(facets.i(k))), j = of(Index(facets.j(k)));
        const Vector gap = j.linear + cross(j.angular, open.arm_j) - i.linear - cross(i.angular, open.arm_i);
        const Vector share = is_i ? turned_by(ends.i, shape.share_i) : turned_by(ends.j, shape.share_j);
        sum += facets.integrity(k) * dot(share, gap);
    });
    const Rate own = of(p);
    const Quaternion<double> q = orientation(gather(pose.data, Short(p)));
    for (Index e = mass.wall_start(p); e < mass.wall_start(p + 1); e++) {
        const Index g = mass.wall(e);
        const Vector moved = own.linear + cross(own.angular, turned_by(q, walls.arm.row<const Vector>(g)));
        sum -= dot(walls.share.row<const Vector>(g), moved);
    }
    return sum;
}

inline Rate velocity_of(const Moving &all, Index p) {
    const double *v = &all.motion(p, 0);
    return {{v[0], v[1], v[2]}, {v[4], v[5], v[6]}};
}

// Finds the acceleration of element p by the loads in a row of the sums. An owner of a row of the boundary also has
// the loads of that row, and no acceleration where its motion is prescribed.
inline void find_acceleration(const Moving &all, const CorrectedMass &mass, const double *sum, Index p) {
    for (Index axis = 0; axis < 3; axis++) {
        mass.acceleration(p, axis) = all.motion(p, 3) * sum[axis];
        mass.acceleration(p, 3 + axis) = all.motion(p, 7) * sum[4 + axis];
    }
}
inline void find_acceleration(const Moving &all, const Rows &rows, const CorrectedMass &mass, const double *sum, Index p) {
    const Index r = rows.of(p);
    for (Index c = 0; c < 6; c++) {
        const double load = sum[c < 3 ? c : c + 1] + rows.force(r, c);
        mass.acceleration(p, c) = rows.fixed(r, c) ? 0.0 : all.motion(p, c < 3 ? 3 : 7) * load;
    }
}

// Finds ρ β θ̈ of cell p by the accelerations of the elements.
inline void find_inertia(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                         const CorrectedMass &mass) {
    const auto of = [&](Index q) { return mass.acceleration.row<const Rate>(q); };
    mass.inertia(p) = mass.factor(p) * dilatation_rate(all.pose, facets, walls, mass, p, of);
}
// Finds the force Θᵀ ρ V β Θ a of the correction on element p.
inline void find_inertia_force(Index p, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                               const CorrectedMass &mass) {
    const FacetColumns columns(facets);
    Vector force = {}, torque = {};
    for_each_bond_of(mass, p, [&](Index k, bool is_i) {
        const Ends<double> ends = ends_of(all.pose.data, facets, k);
        const FacetShape<double> shape = columns.shape<double>(k);
        const OpenFacet<double> open = opened(ends, shape);
        const Vector g = mass.inertia(facets.i(k)) * turned_by(ends.i, shape.share_i) +
                         mass.inertia(facets.j(k)) * turned_by(ends.j, shape.share_j);
        const double sign = is_i ? -facets.integrity(k) : facets.integrity(k);
        force = plus(force, sign, g);
        torque = torque + cross(is_i ? open.arm_i : open.arm_j, sign * g);
    });
    const Quaternion<double> q = orientation(gather(all.pose.data, Short(p)));
    for (Index e = mass.wall_start(p); e < mass.wall_start(p + 1); e++) {
        const Index g = mass.wall(e);
        const Vector f = -mass.inertia(p) * walls.share.row<const Vector>(g);
        force = force + f;
        torque = torque + cross(turned_by(q, walls.arm.row<const Vector>(g)), f);
    }
    for (Index axis = 0; axis < 3; axis++) {
        mass.force(p, axis) = force[axis];
        mass.force(p, 3 + axis) = torque[axis];
    }
}
// Adds the force of the correction to a row of the sums.
inline void add_inertia_force(const CorrectedMass &mass, double *sum, Index p) {
    for (Index axis = 0; axis < 3; axis++) {
        sum[axis] += mass.force(p, axis);
        sum[4 + axis] += mass.force(p, 3 + axis);
    }
}

// Excess ½ ρ V β θ̇² of the kinetic energy of a cell without the correction [J].
inline double surplus_of_kinetic_energy(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass, Index p) {
    const auto of = [&](Index q) { return velocity_of(all, q); };
    const double rate = dilatation_rate(all.pose, facets, walls, mass, p, of);
    return 0.5 * mass.factor(p) * rate * rate;
}

}  // namespace bondem
