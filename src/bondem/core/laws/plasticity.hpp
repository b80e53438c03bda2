// Cells that yield under their stress tensor, the average over the cell. The cohesion falls with plastic slip, and
// the friction is constant.
//
// The yield function F by Mohr and Coulomb has the largest principal stress σ_1 (along e_1) and the least σ_3 (along
// e_3). c is the cohesion, φ the angle of friction and ψ that of dilatancy. Δε is the plastic strain of a step, Δγ
// its slip, r the share of the cohesion that is left, and ⟨x⟩ is x where positive, else 0:
//
//     F = ½ (σ_1 - σ_3) + ½ (σ_1 + σ_3) sin φ - r c cos φ       Δε = ½ Δγ [(1 + sin ψ) e_1⊗e_1 - (1 - sin ψ) e_3⊗e_3]
//     H = G + (λ + G) sin φ sin ψ                               r = ⟨1 - γ B c / 2 G_II⟩
//
// By Drucker and Prager, F has constants α, β and k, and k for c in r. s is the deviator, I1 = tr σ and J2 = ½ s : s.
// For a compressive mean stress,
//
//     F = √J2 + α I1 - r k        H = G + 9 K α β               Δε = Δγ [s / 2 √J2 + β 1]
//
// so that both laws dissipate τ Δγ in pure shear τ. F falls by H Δγ if all cells slip by Δγ at constant total strain.
// G, λ and K are the elastic constants. γ is the mean slip of the cells at a distance of about B/2 from a cell, with
// the width B of a shear band (`damage/shear_bands.py`). Let the faces of a band thinner than B/2 be displaced by u.
// Then γ is u / B for any profile of the band, and the band dissipates the fracture energy G_II per area.
//
// The slip of step n follows from values of F after the previous steps:
//
//     H Δγ_n = H Δγ_(n-1) + (1 - z²) (F_n - F_(n-1)) + (1 - z)² F_n,      z = 0.8
//
// For strains that raise F by a constant amount per step, F then tends to zero as n z^n, without a lag. Elastic modes
// are stable at 0.9 of the critical time step, because z = 2·0.9 - 1 (docs/decisions/0048-shear-bands.md).
//
// The plastic strain is an eigenstrain of the cell. A lever b from its centre to a facet becomes P b, and a step
// changes P to (1 + Δε) P, in the frame of the cell. The dissipation is therefore exactly V σ:Δε, also at large
// strain, with the volume V.
//
// Signs: tension is positive. Limits: a cell without cohesion under tension does not flow, its facets crack.
#pragma once
#include "principal.hpp"

namespace bondem {

// Decay z of the distance from the yield surface per step, and the shares of the growth of F and of F in the slip.
constexpr double decay_of_excess = 0.8;
constexpr double part_of_growth = 1.0 - decay_of_excess * decay_of_excess;
constexpr double part_of_excess = (1.0 - decay_of_excess) * (1.0 - decay_of_excess);

template <class T> struct YieldStrength {
    T cohesion;  // r c cos φ, or r k of the cone [Pa]
    T slope;  // sin φ, or α [-]
    T dilation;  // sin ψ, or β [-]
    T stiffness;  // H [Pa]
    T carry;  // Δγ - (1 - z²) F / H of the step before, 0 without slip [-]
};
// An upper bound of F by Mohr and Coulomb, F itself by the cone [Pa]; -1 by the cone at a mean stress in tension.
template <class T>
BONDEM_INLINE T yield_bound(const StressInvariants<T> &s, const YieldStrength<T> &by, bool cone) {
    if (cone) return select(s.mean > T{}, all<T>(-1.0), s.deviator + 3.0 * by.slope * s.mean - by.cohesion);
    return s.deviator + by.slope * (s.mean + 0.57735026918962576 * s.deviator) - by.cohesion;
}

// F plus the cohesion [Pa]: by Mohr and Coulomb from the extreme principal stresses, or by the cone, 0 in tension.
template <class T> BONDEM_INLINE T sheared(T high, T low, T slope) { return 0.5 * (high - low) + 0.5 * (high + low) * slope; }
template <class T>
BONDEM_INLINE T yield_load(const PrincipalStress<T> &s, const StressInvariants<T> &at, T slope, bool cone) {
    if (cone) return select(at.mean > T{}, T{}, T(at.deviator + 3.0 * slope * at.mean));
    return sheared(largest_of(s), least_of(s), slope);
}

// A step of plastic strain: Δγ, its part from which the next step starts, and Δε along the principal directions.
template <class T> struct PlasticStep {
    T gamma, carry;
    T along[3];
};
// Δγ and its part for the next step; slip is at most `most_slip`.
template <class T> BONDEM_INLINE PlasticStep<T> slip_after(T F, T most_slip, const YieldStrength<T> &by) {
    const T over = F / by.stiffness, zero = {};
    const T gamma = positive(least(T(by.carry + (part_of_growth + part_of_excess) * over), most_slip));
    return {gamma, select(gamma > zero, positive(T(gamma - part_of_growth * over)), zero), {}};
}
template <class T>
BONDEM_INLINE PlasticStep<T> slip_step(const PrincipalStress<T> &s, const YieldStrength<T> &by) {
    const T high = largest_of(s), low = least_of(s), zero = {};
    const T F = sheared(high, low, by.slope) - by.cohesion;
    const auto [gamma, carry, none] = slip_after(F, T(0.25 * (high - low) / by.stiffness), by);
    const T up = 0.5 * gamma * (1.0 + by.dilation), down = -0.5 * gamma * (1.0 - by.dilation);
    // of equal stresses the first is the largest and the last the least
    const Mask<T> up0 = s.stress[0] >= high, up1 = opposite(up0) & (s.stress[1] >= high);
    const Mask<T> low2 = s.stress[2] <= low, low1 = opposite(low2) & (s.stress[1] <= low);
    return {gamma, carry,
            {select(up0, up, select(low2 | low1, zero, down)), select(up1, up, select(low1, down, zero)),
             select(low2, down, select(up0 | up1, zero, up))}};
}
template <class T>
BONDEM_INLINE PlasticStep<T> cone_step(const PrincipalStress<T> &s, const StressInvariants<T> &at,
                                       const YieldStrength<T> &by) {
    const T zero = {}, F = at.deviator + 3.0 * by.slope * at.mean - by.cohesion;
    const PlasticStep<T> slip = slip_after(F, select(at.mean > zero, zero, T(at.deviator / by.stiffness)), by);
    const T gamma = slip.gamma, half = 0.5 / at.deviator;
    const auto along = [&](int d) {
        return select(gamma > zero, T(gamma * ((s.stress[d] - at.mean) * half + by.dilation)), zero);
    };
    return {gamma, slip.carry, {along(0), along(1), along(2)}};
}
// Plastic strain Δε in space.
template <class T> BONDEM_INLINE Symmetric3<T> plastic_strain(const PrincipalStress<T> &s,
                                                              const PlasticStep<T> &step) {
    Symmetric3<T> sum = {};
    for (int d = 0; d < 3; d++) {
        const Vector3<T> e = s.direction[d], a = step.along[d] * e;
        sum = {sum.xx + a.x * e.x, sum.yy + a.y * e.y, sum.zz + a.z * e.z,
               sum.xy + a.x * e.y, sum.xz + a.x * e.z, sum.yz + a.y * e.z};
    }
    return sum;
}
// Plastic work per volume, σ:Δε [Pa].
template <class T> BONDEM_INLINE T work_of(const Symmetric3<T> &s, const Symmetric3<T> &strain) {
    return s.xx * strain.xx + s.yy * strain.yy + s.zz * strain.zz +
           2.0 * (s.xy * strain.xy + s.xz * strain.xz + s.yz * strain.yz);
}

// Plastic deformation P of a cell, stored as the rows of P - 1.
template <class T> struct PlasticDeformation {
    Vector3<T> x, y, z;
};
// Plastic deformation after a step, (1 + Δε) P, with Δε in the frame of the cell.
template <class T>
BONDEM_INLINE PlasticDeformation<T> deformed(const PlasticDeformation<T> &P, const Symmetric3<T> &strain) {
    const auto row = [&](Vector3<T> before, Vector3<T> e, Vector3<T> one) {
        return before + plus(plus(plus(one, e.x, P.x), e.y, P.y), e.z, P.z);
    };
    const Vector3<T> a = {strain.xx, strain.xy, strain.xz}, b = {strain.xy, strain.yy, strain.yz},
                     c = {strain.xz, strain.yz, strain.zz};
    return {row(P.x, a, a), row(P.y, b, b), row(P.z, c, c)};
}
// A lever with the plastic deformation of its cell, P b.
template <class T> BONDEM_INLINE Vector3<T> stretched(const PlasticDeformation<T> &P, Vector3<T> b) {
    return {b.x + dot(P.x, b), b.y + dot(P.y, b), b.z + dot(P.z, b)};
}

}  // namespace bondem
