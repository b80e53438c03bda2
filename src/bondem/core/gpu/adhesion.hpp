// Adhesion on a device: a thread finds the force of one pair of the list, then a thread adds the forces of pairs and
// walls on one element.
#pragma once
#include "../passes/contacts/adhesion.hpp"
#include "contacts.hpp"

namespace bondem {

inline void adhere_one_pair(Index k, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                            const AdheringPairs &of) {
    adhere_pair(all, c, pairs, of, k);
}
inline void add_adhesion_of_element(Index p, const ContactPairs &pairs, const EarlierPairs &earlier, const AdheringPairs &of,
                                    const ContactSums &to) {
    for (Index k = pairs.start(p); k < pairs.start(p + 1); k++) add_adhesion(of, k, true, &to.sums(p, 0));
    for (Index e = earlier.start(p); e < earlier.start(p + 1); e++) add_adhesion(of, earlier.pair(e), false, &to.sums(p, 0));
}
inline void adhere_element_at_walls(Index p, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                                    const WallContacts &contacts, const Walls &walls, const ContactSums &to) {
    adhere_at_walls(turn_of(span, p), all, c, contacts, walls, to);
}
inline void sum_portion_of_adhesion(Index b, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                                    const ContactPairs &pairs, const ContactEnergies &energies) {
    sum_adhesion_energies(portion_of(span, b, elements_of_portion, span.n), all, c, pairs, energies);
}
inline void sum_portion_of_adhesion_at_walls(Index b, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                                             const WallContacts &contacts, const Walls &walls, const ContactEnergies &energies) {
    sum_adhesion_at_walls(portion_of(span, b, elements_of_portion, span.n), all, c, contacts, walls, energies);
}

}  // namespace bondem
