// Adhesion of spheres on a GPU. Passes with one thread per pair compute the force of the pair. Passes with one thread
// per element add the forces of all its pairs, and compute the forces of walls on the element.
#pragma once
#include "../passes/contacts/adhesion.hpp"
#include "contacts.hpp"

namespace bondem {

constexpr auto adhere_one_pair = as<&adhere_pair>;
inline void add_adhesion_of_element(Index p, const ContactPairs &pairs, const EarlierPairs &earlier, const AdheringPairs &of,
                                    const ContactSums &to) {
    for_each_pair_of(pairs, earlier.start, earlier.pair, p,
                     [&](Index k, bool later) { add_adhesion(of, k, later, &to.sums(p, 0)); });
}
constexpr auto adhere_element_at_walls = one_element<adhere_at_walls>;
constexpr auto sum_portion_of_adhesion = portion_of_elements<sum_adhesion_energies>;
constexpr auto sum_portion_of_adhesion_at_walls = portion_of_elements<sum_adhesion_at_walls>;

}  // namespace bondem
