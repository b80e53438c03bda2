// Stress of one element, or of one element per SIMD lane, from the moments Σ b⊗f of the forces f at the levers b.
// Also the rotation of the stress between the frame of the element and fixed axes.
#pragma once
#include "bond_columns.hpp"

namespace bondem {

// Turns the stresses of a step ago with their elements.
template <class Place>
BONDEM_INLINE void turn_stress(const Place &p, const double *pose, const LaggedStresses &stresses) {
    const auto component = [&](Index c) { return number_at(stresses.stress.data, 6, c, p); };
    using T = decltype(component(0));
    const Stress<T> own = {component(0), component(1), component(2), component(3), component(4), component(5)};
    const Stress<T> s = turned_by(matrix_of(orientation(gather(pose, p))), own);
    const T zero = {};
    scatter(stresses.space.data, p, {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, zero, zero}});
}
// Finds stresses of elements, and bounds of their principal stresses; sets the moments to zero.
template <class Place>
BONDEM_INLINE void find_stress(const Place &p, const double *pose, const LaggedStresses &stresses) {
    const auto one = number_at(stresses.inverse.data, 1, 0, p);
    const auto m = stress_of(gather(stresses.moment.data, p));
    clear(stresses.moment.data, p);
    const auto s = one * m;
    const auto bounds = principal_bounds(s);
    scatter(stresses.space.data, p, {{s.xx, s.yy, s.zz, s.xy, s.xz, s.yz, bounds.largest, bounds.least}});
    const auto own = turned_by(inverse(matrix_of(orientation(gather(pose, p)))), s);
    const decltype(own.xx) all_of_it[6] = {own.xx, own.yy, own.zz, own.xy, own.xz, own.yz};
    for (Index c = 0; c < 6; c++) put_number(stresses.stress.data, 6, c, p, all_of_it[c]);
}

}  // namespace bondem
