// Beams that lose their integrity s, from 1 to 0: one energy, a fracture energy for opening and one for shear.
//
//     U = s U0 + (1 - s) ½ kn ⟨L - ℓ⟩²        ⟨x⟩ = x where positive, else 0
//
// with U0 the energy of the intact beam, kn its normal stiffness, L its length at rest and ℓ at present (`beam.hpp`).
// All stiffnesses fall in proportion to s, but the beam carries compression as if it were intact. Forces are the
// exact gradient at fixed s: those of U0 times s, and the pressure (1 - s) kn ⟨L - ℓ⟩ along the beam. Softening
// dissipates
//
//     Y = -∂U/∂s = U0 - ½ kn ⟨L - ℓ⟩² ≥ 0
//
// per unit of lost integrity. The opening λ = √Y grows along any straight path from rest. Integrity falls where λ
// exceeds its previous maximum. The product s λ, proportional to the force, then falls on a line from λ0, where the
// criterion is reached, to λf, where it is zero. Below the previous maximum the beam unloads to its origin:
//
//     s = λ0 (λf - λ) / (λ (λf - λ0))        ∫ Y (-ds) = λ0 λf = G A
//
// on every path along which λ grows, with A the area of the section. The trapezoidal rule counts the same work, also
// for a beam that opens in few steps. The fracture energy G follows from two shares of Y where softening begins:
// share_I of opening (elongation and bending) and share_II of sliding (shear and twisting). G_f and G_II,c are the
// fracture energies of the two modes. With
//
//     G = 1 / (share_I / G_f + share_II / G_II,c)
//
// the energies dissipated in both modes finally satisfy G_I / G_f + G_II / G_II,c = 1. A beam that stores G A / 1.05
// or more at onset breaks while its opening grows by a twentieth.
//
// Linear softening: Hillerborg, Modéer and Petersson (1976). Linear rule of mixed mode: Wu and Reuter (1965), as in
// Camanho and Dávila (2002).
#pragma once
#include "../select.hpp"
#include "beam.hpp"

namespace bondem {

// Parts of Y by opening and by sliding, for the beam without loss of integrity [J].
template <class T> struct OpeningEnergy {
    T opening, sliding;
};
// Parts of Y from the energy of the whole beam; `extension` is ℓ - L [m].
template <class T> BONDEM_INLINE OpeningEnergy<T> opening_energy(const BeamEnergy<T> &whole, T extension) {
    const T zero = {}, pulled = extension > zero ? whole.normal : zero;
    return {positive(T(whole.bending + pulled)), positive(T(whole.shear + whole.twisting))};
}

// Least ratio of λf to λ0, of beams that store the fracture energy G A or nearly as much at onset.
constexpr double snap_of_beams = 1.05;

// Opening λf at s = 0 of a beam that softens from λ0 = `first` [√J]; `tear` is G_f A and `slide` G_II,c A [J].
inline double last_opening(const OpeningEnergy<double> &at_first, double tear, double slide, double first) {
    const double energy = (at_first.opening + at_first.sliding) / (at_first.opening / tear + at_first.sliding / slide);
    return most(energy / first, snap_of_beams * first);
}
// Fracture energy G A [J]: λ0 λf, or `of_mode` for a beam that stores as much or nearly as much at onset.
inline double absorbed_energy(double first, double last, double of_mode) {
    return last > snap_of_beams * first ? first * last : of_mode;
}

// Line on which s λ falls from λ0 = `first` to zero at λf = `last`; below λ0, s λ = λ.
struct SofteningLine {
    double first, last;

    double at(double opening) const {
        if (opening <= first) return opening;
        return opening >= last ? 0.0 : first * (1.0 - opening / last) / (1.0 - first / last);
    }
    // Work that a beam absorbs from an opening of at least λ0 to its last one [J].
    double beyond(double opening) const { return opening >= last ? 0.0 : (last - opening) * at(opening); }
};

// Integrity, at most s, of a beam whose opening grows from `before` to `opening` in a step; it has dissipated
// `spent` [J].
//
// Where the line has no corner, the trapezoidal work of steps of equal size d is the area below the line. A step
// across a corner counts a different work, and none in a jump from zero beyond the last opening. There the force s λ
// follows from the rest of G A: the work of this step, of a next one of equal size and of the line behind it. The
// force stays between those of the line a step before and a step after, so that it tends to the line with d. For a
// whole beam that was in compression, `before` is negative; the last term compensates for its pressure, which acts
// half a step too long.
inline double softened(double s, const SofteningLine &line, double spent, double before, double opening) {
    const double step = opening - before, opened = positive(before);
    if (s * opening <= line.at(opening)) return s;
    if (!(step > 0.0)) return line.at(opening) / opening;
    const double next = opening + step, force_next = line.at(next);
    const double absorbed = spent + s * opened * opened, left = line.first * line.last - absorbed - line.beyond(next);
    const double wanted = 0.5 * (left / step - s * opened - force_next);
    const double force = within(wanted, force_next, least(s * opening, line.at(most(opened, line.first))));
    return least(s, force / opening + 0.5 * positive(-before) / step);
}

// Pressure that the softened part of a beam carries along the branch: force on j over `press` = (1 - s) kn [m].
template <class T> BONDEM_INLINE Vector3<T> pressure_on(Vector3<T> branch, T rest_length) {
    const T present = length(branch);
    return (positive(T(rest_length - present)) / present) * branch;
}

}  // namespace bondem
