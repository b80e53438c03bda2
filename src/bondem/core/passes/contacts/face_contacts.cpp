// Passes that add up forces and energies of pairs of cells that touch by faces (`face_contacts.hpp`).
#include "face_contacts.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"

namespace bondem {
// Adds forces of faces to the elements of a range.
void add_face_loads(const Range &range, const ContactPairs &pairs, const FacePairs &faces, const ContactSums &to) {
    over_listed_pairs(range, pairs, faces.close, [&](Index q) { return faces.count(q); },
                      [&](Short k, Short p, bool later) { add_faces_to(faces, k, later, &to.sums(p, 0)); });
}
BONDEM_PASS(add_face_loads, of_ranges, "adds sums")

void sum_face_energies(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                       const FacePairs &faces, const Ledger &ledger) {
    add_up(ledger, history_column::contact, pairs.start(range.first), pairs.start(range.last),
           [&](Index k) { return pairs.touch(k) == facing ? face_energy(all, c, pairs, faces, k) : 0.0; });
}
BONDEM_PASS(sum_face_energies, of_elements, "")

}  // namespace bondem
