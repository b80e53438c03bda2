// Criteria that are functions of a stress tensor, evaluated once per step for all bonds or facets near failure.
//
// A pass over bonds writes candidates (`write_candidate`), with a list per range of bonds. `index_candidates_by_…`
// joins the lists and evaluates the function: one of the core, or a C function of the user,
//
//     void function(int64_t count, const double *stress, const double *parameter, double *index)
//
// which writes an index for each of `count` symmetric stresses (count, 3, 3) [Pa], tension positive. A bond fails
// where its index is at least 1, or NaN. The function is called on the thread that called the core, only if there are
// candidates. A function written in Python acquires the lock of the interpreter by itself.
#pragma once
#include "../../laws/stress.hpp"
#include "../../steps.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Writes a candidate of a portion; returns the place of the next one.
template <class Candidates>
inline Index write_candidate(const Candidates &candidates, Index place, Index bond, const Stress<double> &s) {
    candidates.bond(place) = bond;
    const double all[9] = {s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz};
    for (Index c = 0; c < 9; c++) candidates.stress.data[9 * place + c] = all[c];
    return place + 1;
}
// Reads the stress of candidate c.
template <class Candidates> inline Stress<double> stress_in(const Candidates &candidates, Index c) {
    const double *s = candidates.stress.data + 9 * c;
    return {s[0], s[4], s[8], s[1], s[2], s[5]};
}

}  // namespace bondem
