// Cells and the facets between them: one energy with E and ν of the material, its gradient, and its parts.
//
// Every element is the rigid core of a cell of a Laguerre tessellation, with its centre x at the centre of mass of
// the cell. Cells i and j share a facet of area A and unit normal n, from i to j, with a face on each cell. In the
// reference every orientation R is the identity. b is the lever from the centre of a cell to the centroid of the
// facet. The share of a facet in the volume change V θ of its cell p is
//
//     s_p = A w_p m_p      w_p = d_p / L      s_i + s_j = A n, with the normal n of cell i
//
// d_p is the distance of the plane of the facet from the generator of the cell, the centre of its sphere. L is
// d_i + d_j, and m_p a vector that equals n on average. Balanced shares make every uniform stress exact in every cell
// (`bondem/specimen/tessellation/balanced_shares.py`). Then
//
//     δ = x_j + R_j b_j - x_i - R_i b_i                     gap of the two faces; needs no frame of reference
//     V_p θ_p = Σ (R_p s_p) · δ                             over the facets of the cell
//     U = Σ [½ k |δ|² + 2 v · H v] + Σ ½ V_p λ_p θ_p²       over facets, and over cells
//
//     k = 2 G A / L      H = (2 G / L) (tr S 1 - S)      λ_p = λ / (1 + c_p λ / 2 G)
//     G = E / (2 (1 + ν))      λ = E ν / ((1 + ν) (1 - 2 ν))      c_p = 1/V_p Σ A d |m|²   over free facets
//
// v is the vector part of the relative rotation q_i* q_j, a quaternion, and S the second moment of the facet about
// its centroid, a tensor. 2 v · H v is exactly (2 G / L) tr((1 - R_iᵀ R_j) S), the energy of a facet whose points
// open differently. For a small rotation ρ this energy is ½ ρ · H ρ. λ_p is smaller than λ because free facets open
// until their traction vanishes. `bondem/interactions/cells/cell_constants.py` computes the constants once.
//
// With the stress σ = λ_p θ_p of a cell and g = σ R s, the loads on both cells, minus the gradient of U, are
//
//     f = k δ + g_i + g_j
//     F_i = f     T_i = (R_i b_i) × f + δ × g_i
//     F_j = -f    T_j = -(R_j b_j) × f + δ × g_j        ± the moment of 2 v · H v, + on i (`bending_moment`)
//
// where δ × g comes from normals that turn with their cells. Cells need passes for dilatation and then for forces.
//
// Signs: tension is positive. `BeamLoads` has the force on j, as beams do, and its opposite acts on i.
//
// U does not change under rigid motion, has no square root and no history, and is positive for -1 < ν < ½. Facets
// alone are the lattice of Bolander and Saito (1998), whose ν is 0. With m = n the law is that of Mariotti (2007) and
// of Monasse and Mariotti (2012).
//
// Limits: relative rotations are moderate, as for beams (`laws/beam.hpp`), and strains small: θ is linear in δ.
#pragma once
#include "../symmetric3.hpp"
#include "ends.hpp"

namespace bondem {

// Geometry of a facet in the reference, relative to its two cells.
template <class T> struct FacetShape {
    Vector3<T> lever_i, lever_j;  // b [m]
    Vector3<T> share_i, share_j;  // s [m²]
};
// Constants of the energy of a facet.
template <class T> struct FacetStiffness {
    T k;  // [N/m]
    Symmetric3<T> H;  // [N·m]
};
// Two numbers, one per cell of a facet, such as their stresses σ [Pa].
template <class T> struct OfCells {
    T i, j;
};
template <class T> using FacetLoads = BeamLoads<T>;

// A facet in space: the turned levers R b of both cells, and the gap δ [m].
template <class T> struct OpenFacet {
    Vector3<T> arm_i, arm_j, gap;
};
template <class T> BONDEM_INLINE OpenFacet<T> opened(const Ends<T> &ends, const FacetShape<T> &shape) {
    const Vector3<T> a = turned_by(ends.i, shape.lever_i), b = turned_by(ends.j, shape.lever_j);
    return {a, b, ends.branch + b - a};
}

// Contributions of a facet to V θ of its cells [m³].
template <class T> BONDEM_INLINE OfCells<T> dilatation(const Ends<T> &ends, const FacetShape<T> &shape) {
    const Vector3<T> gap = opened(ends, shape).gap;
    return {dot(turned_by(ends.i, shape.share_i), gap), dot(turned_by(ends.j, shape.share_j), gap)};
}

// The force f of a facet on its cell i [N].
template <class T>
BONDEM_INLINE Vector3<T> facet_pull(const Ends<T> &ends, const FacetShape<T> &shape, T k, OfCells<T> stress) {
    const Vector3<T> g_i = stress.i * turned_by(ends.i, shape.share_i), g_j = stress.j * turned_by(ends.j, shape.share_j);
    return plus(g_i + g_j, k, opened(ends, shape).gap);
}

// The relative rotation q_i* q_j: its scalar, and its vector in the frame of the reference and in space.
template <class T> struct RelativeTurn {
    T w;
    Vector3<T> v, space;
};
template <class T> BONDEM_INLINE RelativeTurn<T> relative_turn(Quaternion<T> p, Quaternion<T> q) {
    const Vector3<T> plain = {p.w * q.x - q.w * p.x, p.w * q.y - q.w * p.y, p.w * q.z - q.w * p.z};
    const Vector3<T> across = cross(Vector3<T>{p.x, p.y, p.z}, Vector3<T>{q.x, q.y, q.z});
    return {relative_cosine(p, q), plain - across, plain + across};
}

// Energy 2 v · H v of the bending of a facet [J], and its torque on i in space [N·m]; the opposite torque acts on j.
template <class T> struct FacetBending {
    T energy;
    Vector3<T> torque;
};
template <class T> BONDEM_INLINE FacetBending<T> facet_bending(const Ends<T> &ends, const Symmetric3<T> &H) {
    const RelativeTurn<T> turn = relative_turn(ends.i, ends.j);
    const Vector3<T> resisted = H * turn.v, h = turned_by(ends.i, resisted);
    const Vector3<T> c = plus_cross(turn.w * h, turn.space, h);
    return {2.0 * dot(turn.v, resisted), c + c};
}
template <class T> BONDEM_INLINE Vector3<T> bending_moment(const Ends<T> &ends, const Symmetric3<T> &H) {
    return facet_bending(ends, H).torque;
}

// Force and torques of a facet at known stresses of both cells: minus the gradient of U. Callers pass the facet in
// space, whose arms they need too, and its bending moment, because computing it first takes fewer registers.
template <class T>
BONDEM_INLINE FacetLoads<T> facet_loads(const Ends<T> &ends, const FacetShape<T> &shape, const OpenFacet<T> &open,
                                        Vector3<T> moment, T k, OfCells<T> stress) {
    const Vector3<T> g_i = stress.i * turned_by(ends.i, shape.share_i), g_j = stress.j * turned_by(ends.j, shape.share_j);
    const Vector3<T> m_i = plus_cross(moment, open.gap, g_i), m_j = plus_cross(-moment, open.gap, g_j);
    const Vector3<T> f = plus(g_i + g_j, k, open.gap);
    return {-f, plus_cross(m_i, open.arm_i, f), minus_cross(m_j, open.arm_j, f)};
}
template <class T>
BONDEM_INLINE FacetLoads<T> facet_loads(const Ends<T> &ends, const FacetShape<T> &shape,
                                        const FacetStiffness<T> &stiffness, OfCells<T> stress) {
    const Vector3<T> moment = bending_moment(ends, stiffness.H);
    return facet_loads(ends, shape, opened(ends, shape), moment, stiffness.k, stress);
}

// Energy of a facet in four modes, without dilatation. `normal` is n in the reference; in space it is the mean of n
// of both cells.
template <class T>
BONDEM_INLINE BeamEnergy<T> facet_energy(const Ends<T> &ends, const FacetShape<T> &shape, Vector3<T> normal,
                                          const FacetStiffness<T> &stiffness) {
    const Vector3<T> gap = opened(ends, shape).gap, n = turned_by(ends.i, normal) + turned_by(ends.j, normal);
    const T opening = dot(gap, n), across = opening * opening / dot(n, n);
    const Vector3<T> v = relative_turn(ends.i, ends.j).v;
    const T whole = 2.0 * dot(v, stiffness.H * v), along = dot(v, normal);
    const T twisting = 2.0 * along * along * dot(normal, stiffness.H * normal);
    return {0.5 * stiffness.k * across, 0.5 * stiffness.k * (dot(gap, gap) - across), whole - twisting, twisting};
}

// The unit normal of a facet in space: the normalised mean of n turned with each cell.
inline Vector present_normal(const Ends<double> &ends, Vector normal) {
    const Vector n = turned_by(ends.i, normal) + turned_by(ends.j, normal);
    return n / length(n);
}

// Mean square of the differences of traction between points of a facet [Pa²], from its bending and twisting: 2 k / A²
// times 2 v · H v; `factor` is 4 k / A² [N/m⁵].
template <class T> BONDEM_INLINE T bending_square(const Ends<T> &ends, T factor, const Symmetric3<T> &H) {
    const Vector3<T> v = relative_turn(ends.i, ends.j).v;
    return factor * dot(v, H * v);
}

// Ratio n · H n / tr H below which the resistance of a facet to twisting is a rounding error.
constexpr double free_twist = 1e-5;

// cos² of half the relative angle of two cells, without a twist that their facet does not resist, because a cell on a
// single facet may spin about its normal. `w2` is cos² of half the whole angle.
inline double swing_square(const Ends<double> &ends, double w2, Vector normal, const Symmetric3<double> &H) {
    if (dot(normal, H * normal) > free_twist * trace(H)) return w2;
    const double twist = dot(relative_turn(ends.i, ends.j).v, normal);
    return w2 + twist * twist;
}

}  // namespace bondem
