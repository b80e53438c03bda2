// Contacts on a GPU that begin where bonds fail or cracks part in a step (`passes/contacts/handover.hpp`). One thread
// per failed bond begins the contact of its two elements. One thread per element adds the forces of new contacts.
#pragma once
#include "../passes/contacts/handover.hpp"
#include "breakage.hpp"
#include "contacts.hpp"
#include "cracks.hpp"

namespace bondem {

// Contact pair of the bond of an event, below 0 if the pair is not listed.
BONDEM_INLINE Index pair_of_event(const ContactPairs &pairs, const EventLog &log, Index event) {
    return pairs.of_bond(Index(log.event(event, event_column::bond)));
}
// Begins the contact of event number e of this step. The output of its pair has the force, the energy that moves from
// the event to the contact, the torque, and whether the two touch.
inline void begin_contact_of_event(Index e, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                                   const NearPairs &near, const EventLog &log) {
    const Index event = log.written(log_count::before) + e;
    if (event >= log.written(log_count::events)) return;
    const Index k = pair_of_event(pairs, log, event);
    if (k < 0) return;
    const NewContact contact = begin_pair(all, c, pairs, k, log.pressed(event));
    const double energy = contact.touches ? pair_energy(all.pose.data, c, pairs, k) : 0.0;
    const Vector f = contact.force, t = contact.torque;
    near.output.row<Row<double>>(k) = {{f.x, f.y, f.z, energy, t.x, t.y, t.z, contact.touches ? 1.0 : 0.0}};
    log.event(event, event_column::energy) -= energy;
}
inline void add_new_contacts_of_element(Index p, const BondsOfElements &bonds, const BondMarks &marks,
                                          const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near,
                                          const EventLog &log, const Postponed &postponed) {
    if (log.written(log_count::before) == log.written(log_count::events) || !is_postponed(postponed, p)) return;
    for_each_failing_of(p, bonds, marks, [&](Index bond, bool) {
        const Index k = pairs.of_bond(bond);
        if (k < 0) return;
        const double *const out = near.output.row<Row<double>>(k).column;
        if (out[7] == 0.0) return;
        const NewContact contact = {true, {out[0], out[1], out[2]}, {out[4], out[5], out[6]}};
        add_new_contact(&postponed.sum(p, 0), pairs.second(k) == Short(p), c.radius(p), contact);
    });
}
// Subtracts the energies that contacts store from the energy released in the run.
inline void take_over_energies(Index, const ContactPairs &pairs, const NearPairs &near, const EventLog &log) {
    if (!any_event(log)) return;
    ExactSum stored = {};
    for_each_event(log, [&](Index bond, Index) {
        const Index k = pairs.of_bond(bond);
        if (k >= 0) stored.add(near.output(k, 3));
    });
    log.released(0) -= stored.value();
}

// ---- cells whose crack has parted

// Begins to evaluate the pair of cells of facet k if its crack has parted in this step.
inline void touch_parted_face(Index k, const Moving &all, const ContactPairs &pairs, const CohesiveCracks &cracks,
                              const CrackLists &lists, const PartedReach &reach) {
    if (lists.flag(k) != crack::parts && lists.waking(k) != crack::parts) return;
    shape_of(cracks, k).top = reach.apart(k) = open_pair(all, pairs, k, reach.apart(k));
}
// Marks the faces of facet k that part in this step, and their cells.
inline void open_face(Index k, const ContactPairs &pairs, const FacePairs &faces, const CrackLists &lists) {
    if (lists.flag(k) != crack::parts && lists.waking(k) != crack::parts) return;
    mark_parting(pairs, faces, k, pairs.of_bond(k));
}
// Begins the contact of the faces of pair k that part in this step.
inline void begin_faces_of_pair(Index k, const Moving &all, const ContactPairs &pairs, const FacePairs &faces) {
    const bool begins = faces.faced(pairs.first(k)) == 2 || faces.faced(pairs.second(k)) == 2;
    faces.gained(k) = begins ? begin_by_faces(all, pairs, faces, k) : 0.0;
    if (begins) exact_sum(faces.gained_sum, 0).add_shared(faces.gained(k));
}
inline void settle_face(Index k, const FacePairs &faces) {
    if (faces.open(k) == 2) faces.open(k) = 1;
}
inline void settle_faces_of_cell(Index p, const FacePairs &faces) {
    if (faces.faced(p) == 2) faces.faced(p) = 1;
}
// Subtracts the energy that faces store as they begin to touch from the released energy.
inline void take_over_from_cracks(Index, const FacePairs &faces, const EventLog &log) {
    log.released(0) -= exact_sum(faces.gained_sum, 0).take();
}

}  // namespace bondem
