// Resistance of spheres to rolling on a GPU. Passes with one thread per pair compute the moments of the pair. Passes
// with one thread per element add the moments of all its pairs, and compute the moments at walls.
#pragma once
#include "../passes/contacts/rolling.hpp"
#include "contacts.hpp"

namespace bondem {

inline void roll_one_pair(Index k, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                          const ContactPairs &pairs, const NearPairs &near, const RolledPairs &of) {
    if (as_spheres(pairs.touch(k))) roll_pair(all, c, pairs, of, k, near.output.row<const Vector>(k), clock_of(span).dt);
}
inline void add_rolling_of_element(Index p, const ContactPairs &pairs, const EarlierPairs &earlier, const RolledPairs &of,
                                   const ContactSums &to) {
    for_each_pair_of(pairs, earlier.start, earlier.pair, p, [&](Index k, bool later) {
        if (as_spheres(pairs.touch(k))) add_rolling(of, k, later, &to.sums(p, 0));
    });
}
constexpr auto roll_element_at_walls = one_element<roll_at_walls>;
constexpr auto sum_portion_of_rolling = portion_of_elements<sum_rolling_energies>;
constexpr auto sum_portion_of_rolling_at_walls = portion_of_elements<sum_rolling_at_walls>;

}  // namespace bondem
