#include "face_contacts.hpp"

#include "../../registered.hpp"

namespace bondem {
// Adds forces of faces to the elements of a range.
void add_face_loads(const Turn &turn, const ContactPairs &pairs, const FacePairs &faces, const ContactSums &to) {
    const auto mine = [&](Short p) { return turn.first <= p && p < turn.last; };
    for (Index q = turn.first / elements_of_portion; q < faces.count.size(); q++) {
        const Index begin = pairs.start(elements_of_portion * q), end = begin + faces.count(q);
        for (Index e = begin; e < end; e++) {
            const Short k = faces.close(e), a = pairs.first(k), b = pairs.second(k);
            if (mine(a)) add_faces_to(faces, k, false, &to.sums(a, 0));
            if (mine(b)) add_faces_to(faces, k, true, &to.sums(b, 0));
        }
    }
}
BONDEM_PASS(add_face_loads, of_ranges)

void sum_face_energies(const Turn &turn, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                       const FacePairs &faces, const ContactEnergies &energies) {
    double sum = 0.0;
    for (Index k = pairs.start(turn.first); k < pairs.start(turn.last); k++)
        if (pairs.touch(k) == facing) sum += face_energy(all, c, pairs, faces, k);
    energies.energy(turn.block) += sum;
}
BONDEM_PASS(sum_face_energies, of_elements)


}  // namespace bondem
