#include "face_contacts.hpp"

#include "../../registered.hpp"
#include "handover.hpp"

namespace bondem {
namespace {

// Calls on(pair) for the listed pairs of cell p.
template <class On> void over_pairs_of(const ContactPairs &pairs, const FacePairs &faces, Short p, On on) {
    for (Index k = pairs.start(p); k < pairs.start(p + 1); k++) on(k);
    for (Index e = faces.earlier_start(p); e < faces.earlier_start(p + 1); e++) on(Index(faces.earlier(e)));
}

}  // namespace

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

// Begins the contact of faces that part in this step.
void begin_face_contacts(const Turn &, const Moving &all, const ContactPairs &pairs, const NearPairs &near,
                         const FacePairs &faces, const CrackLists &lists, const EventLog &log) {
    const Index count = lists.size(3);
    if (count == 0) return;
    const auto over_parted = [&](auto on) {
        for (Index e = 0; e < count; e++) {
            const Index k = lists.parted(e), pair = pairs.of_bond(k);
            on(k, pairs.first(pair), pairs.second(pair), pair);
        }
    };
    const auto over_all_pairs = [&](auto on) {
        over_parted([&](Index k, Short a, Short b, Index) {
            if (!has_faces(faces, k)) return;
            over_pairs_of(pairs, faces, a, on);
            over_pairs_of(pairs, faces, b, on);
        });
    };
    over_parted([&](Index k, Short, Short, Index pair) { mark_parting(pairs, faces, k, pair); });
    constexpr double unknown = infinity;
    over_all_pairs([&](Index k) { faces.gained(k) = unknown; });
    double gained = 0.0;
    over_all_pairs([&](Index k) {
        if (faces.gained(k) != unknown) return;
        faces.gained(k) = begin_by_faces(all, pairs, faces, k);
        gained += faces.gained(k);
        if (!bonded(pairs, k)) examine(pairs, near, k);
    });
    log.released(0) -= gained;
    over_parted([&](Index k, Short a, Short b, Index) {
        if (has_faces(faces, k)) faces.open(k) = faces.faced(a) = faces.faced(b) = 1;
    });
}
BONDEM_PASS(begin_face_contacts, serial)

}  // namespace bondem
