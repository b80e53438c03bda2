// Failure index (1 at failure) of a bond of the non-local law, by the mean stress of its two elements.
#pragma once
#include "../../laws/criteria/principal_stress.hpp"
#include "../../laws/principal.hpp"
#include "../damage/pipeline.hpp"
#include "bond_columns.hpp"

namespace bondem {

// Columns of a stress in global axes with bounds of its largest and its least principal stress.
enum BoundColumn : Index { largest_column = 6, least_column };

// An index that is at least that of the criterion, by the rows of both elements: σ1 of a mean is at most the mean of
// both σ1, and σ3 at least the mean of both σ3.
template <class T>
BONDEM_INLINE T bound_of_index(const Row<T> &i, const Row<T> &j, const Coefficients<T> &own) {
    const T largest = 0.5 * (i.column[largest_column] + j.column[largest_column]);
    const T lowest = 0.5 * (i.column[least_column] + j.column[least_column]);
    return PrincipalStressCriterion::verdict(largest, lowest, own).index;
}
inline Verdict<double> verdict_of_pair(const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                                       Index k) {
    const auto stress = [&](Short p) { return stresses.space.row<const Stress<double>>(p); };
    const PrincipalStress<double> found = principal(mean_of(stress(beams.i(k)), stress(beams.j(k))));
    return PrincipalStressCriterion::verdict(largest_of(found), least_of(found), coefficients_of(strengths, k));
}

}  // namespace bondem
