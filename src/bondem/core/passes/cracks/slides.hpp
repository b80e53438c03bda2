// Slip of the faces of cracks: the shear that an open crack transmits falls with its opening.
//
// A crack crosses a body by inclined facets. The shear of the cracked facets of a cell has a common part by sliding
// along the crack. Another part, by stress along the crack, alternates from facet to facet. Only the common part may
// fall as the crack opens. Therefore a cell has one slip b for all its cracked facets. For each of these facets, e is
// the normal of its crack, P = 1 - e⊗e, and ± f the force on the cell. The facet has the outward normal n, the area
// A, the stiffness k and the strength f_t. r is the traction that the crack can transmit across, over its strength,
// and ω = 1 - r. With σ the stress of the cell, and ⟨x⟩ = x where positive, else 0,
//
//     R = Σ ω [± P f - A P σ P n]        K = Σ ω² k        C = Σ ω A |n·e| r f_t        N = Σ ω f·e
//     transmitted by the crack: L = √(C² - ⟨N⟩²) + μ ⟨-N⟩ with the friction μ of one of its facets
//     cell: where |R| > L and R·Σ ± ω P f > 0,  b = ½ (1 - L / |R|) R / K        facet: slip += ω P (b_i - b_j)
//
// The term with σ in the sliding force R removes a uniform stress along the crack. Each cell of a facet contributes
// half of the slip. A facet slips until it has dissipated two fracture energies, one for its opening and one for its
// slip. Without this limit, the stress along the crack below an impact would do work on slip that no cohesion
// resists. Slip only dissipates. The work of slip is that of the mean force before and after the step.
#pragma once
#include "carried.hpp"

namespace bondem {

// Share of the slip of a step that continues in the next one; it reduces the lag of steady slip to a fifth.
constexpr double lasting_slip = 0.8;

// Shear that the cracks of a group transmit without friction: over their strength [-], and as a force [N].
template <class T> struct Cohesion {
    T share, force;
};
template <class T>
BONDEM_INLINE Cohesion<T> cohesion_of(const CrackPlace<T> &at, const CrackSoftening<T> &of, const FacetStrengths &strengths) {
    if (!any(at.now.left.s[0] > T{})) return {T{}, T{}};
    const Softening<T> facet = {of.strength, of.brittleness};
    const T slope = absolute(dot(at.now.normal, at.now.across()));
    const T share = borne_of(at.now.left.s[0], most(slope, all<T>(least_slope)), facet,
                             CurveShape{strengths.kink, strengths.steep});
    return {share, at.area * slope * share * facet.strength};
}

// Share of friction in the work of slip of a crack [-]: μ times its pressure over that and its cohesion; `both` is
// the sum of its forces before and after [N].
template <class T>
BONDEM_INLINE T friction_share(const CrackPlace<T> &at, Vector3<T> both, const CrackSoftening<T> &of,
                               const FacetStrengths &strengths) {
    const T rubs = at.friction * positive(T(-0.5 * dot(both, at.now.across()))), zero = {};
    return select(rubs > zero, T(rubs / (rubs + cohesion_of(at, of, strengths).force)), zero);
}

// Writes the parts of R, K, Σ ± ω P f and C of each half, 0 for cracks with friction. Returns the part of N.
template <class Group, class T = typename Group::Number>
BONDEM_INLINE T shear_each(const Group &group, const CrackPlace<T> &at, Vector3<T> f, Mask<T> treated,
                              const CrackSoftening<T> &of, const FacetStrengths &strengths,
                              const StressesOfCells &stresses, const CrackLists &lists) {
    const T zero = {}, one = all<T>(1.0), s = at.now.left.s[0];
    const Mask<T> slides = treated & opposite(at.now.rubs) & (s < one) & (at.slips > zero);
    Row<T> i = {}, j = {};
    T across = {};
    if (any(slides)) {
        const Vector3<T> e = at.now.across(), n = at.now.normal;
        const Cohesion<T> cohesion = cohesion_of(at, of, strengths);
        const T loose = select(slides, T(one - cohesion.share), zero), along = dot(f, e);
        const Vector3<T> shear = loose * minus(f, along, e), flat = minus(n, dot(n, e), e);
        const auto of_stress = [&](const Row<T> &row) {
            const T *const c = row.column;
            const Vector3<T> t = Symmetric3<T>{c[0], c[1], c[2], c[3], c[4], c[5]} * flat;
            return (loose * at.area) * minus(t, dot(t, e), e);
        };
        const Vector3<T> of_i = shear - of_stress(gather(stresses.tensor.data, group.i));
        const Vector3<T> of_j = of_stress(gather(stresses.tensor.data, group.j)) - shear;
        const T stiff = loose * loose * at.facet.k, bears = loose * cohesion.force;
        across = loose * along;
        i = {{of_i.x, of_i.y, of_i.z, stiff, shear.x, shear.y, shear.z, bears}};
        j = {{of_j.x, of_j.y, of_j.z, stiff, -shear.x, -shear.y, -shear.z, bears}};
    }
    group.put_halves(lists, i, j, crack::slides);
    return across;
}

// Sums the forces of the cracks of cell p, and finds their slip. `on_half()` is called once for each half.
template <class OnHalf>
inline void sum_cracks_of(const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists,
                          Index p, OnHalf on_half) {
    Four sum[4] = {};  // forces, torques, and the two parts of `crack::slides`
    Carried carried = {};
    for (Index h = lists.head(p); h > 0;) {
        const FourInMemory *const half = reinterpret_cast<const FourInMemory *>(lists.half.data + 16 * h);
        on_half();
        for (int c = 0; c < 4; c++) sum[c] += half[c];
        carried.add(lever_of(cracks, h), half[0]);
        h = lists.next.data[h];
    }
    double *const output = lists.sum.data + 8 * p;
    for (int c = 0; c < 8; c++) output[c] = sum[c / 4][c % 4];
    carried.put(stresses, cracks.pitch.data, p);
    const double across = output[7];
    const Vector R = {sum[2][0], sum[2][1], sum[2][2]}, as_is = {sum[3][0], sum[3][1], sum[3][2]};
    const double size = length(R), stiff = sum[2][3], cohesion = sum[3][3], pull = positive(across);
    const double friction = across < 0.0 ? face_of(cracks, facet_of(lists.head(p))).friction : 0.0;
    const double bears = root(positive(cohesion * cohesion - pull * pull)) - friction * least(across, 0.0);
    const bool slides = size > bears && dot(R, as_is) > 0.0;
    const Vector b = slides ? (0.5 * (1.0 - bears / size) / stiff) * R : Vector{};
    for (int d = 0; d < 3; d++) lists.slip(p, d) = b[d];
}

// Applies the slip of both cells to the crack of facet k.
inline void slide_crack(const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                        const CrackLists &lists, Index k) {
    CrackStateRow &state = state_of(cracks, k);
    if (state.kind != crack::of_material) return;
    const Short i = facets.i(k), j = facets.j(k);
    const double *const a = &lists.slip(i, 0), *const b = &lists.slip(j, 0);
    const Vector apart = {a[0] - b[0], a[1] - b[1], a[2] - b[2]}, before = {state.rub[0], state.rub[1], state.rub[2]};
    if (dot(before, before) != 0.0) state.rub[0] = state.rub[1] = state.rub[2] = 0.0;
    if (dot(apart, apart) == 0.0) return;
    const double stiff = lists.half(half_of(k, 0), crack::slides + 3);
    if (stiff == 0.0) return;
    const Quaternion<double> turn = orientation(gather(all.pose.data, i));
    const Vector across = axes_of(turn, quaternion_of(frame_of(cracks, k).axes)).e[0];
    const double loose = root(stiff / face_of(cracks, k).k);
    Vector increment = turned_by(inverse(turn), loose * minus(apart, dot(apart, across), across));
    // continuing slip has no lag where it dissipates energy
    const Vector more = plus(increment, lasting_slip, before);
    const Vector f = {cracks.pull(k, 0), cracks.pull(k, 1), cracks.pull(k, 2)};
    if (dot(increment, before) > 0.0 && dot(f, turned_by(turn, more)) > 0.0) increment = more;
    for (int d = 0; d < 3; d++) state.slip[d] += increment[d], state.rub[d] = increment[d];
}

}  // namespace bondem
