// Contacts on a device that begin where bonds have broken in a step: a thread begins one contact, then a thread adds
// the contacts of one element.
#pragma once
#include "../passes/contacts/handover.hpp"
#include "breakage.hpp"
#include "contacts.hpp"

namespace bondem {

// Pair of an event of this step, or below 0.
BONDEM_INLINE Index pair_of_event(const ContactPairs &pairs, const EventLog &log, Index event) {
    return pairs.of_bond(Index(log.event(event, event_column::bond)));
}
// Begins the contact of event number e of this step. The output of its pair has the force, the energy that moves from
// the event to the contact, the torque, and whether the two touch.
inline void begin_contact_of_event(Index e, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                                   const NearPairs &near, const EventLog &log) {
    const Index event = log.written(1) + e;
    if (event >= log.written(0)) return;
    const Index k = pair_of_event(pairs, log, event);
    if (k < 0) return;
    const BegunContact begun = begin_pair(all, c, pairs, k);
    const double energy = begun.touches ? pair_energy(all.pose.data, c, pairs, k) : 0.0;
    const Vector f = begun.force, t = begun.torque;
    near.output.row<Row<double>>(k) = {{f.x, f.y, f.z, energy, t.x, t.y, t.z, begun.touches ? 1.0 : 0.0}};
    log.event(event, event_column::energy) -= energy;
}
inline void add_begun_contacts_of_element(Index p, const BondsOfElements &bonds, const BondMarks &marks,
                                          const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near,
                                          const EventLog &log, const Postponed &postponed) {
    if (log.written(1) == log.written(0) || !is_held(postponed, p)) return;
    for_each_failing_of(p, bonds, marks, [&](Index bond, bool) {
        const Index k = pairs.of_bond(bond);
        if (k < 0) return;
        const double *const out = near.output.row<Row<double>>(k).column;
        if (out[7] == 0.0) return;
        const BegunContact begun = {true, {out[0], out[1], out[2]}, {out[4], out[5], out[6]}};
        add_begun(&postponed.kept(p, 0), pairs.second(k) == Short(p), c.radius(p), begun);
    });
}
// Subtracts the energies that contacts store from the energy released in the run, in the order of the events.
inline void take_over_energies(Index, const ContactPairs &pairs, const NearPairs &near, const EventLog &log) {
    for (Index event = log.written(1); event < log.written(0); event++) {
        const Index k = pair_of_event(pairs, log, event);
        if (k >= 0) log.released(0) -= near.output(k, 3);
    }
}

}  // namespace bondem
