// Contact of two elements whose bond or facet has failed. Until then their pair is in the list of contacts, but is
// not evaluated.
//
// The elements press on each other immediately, with the tangential spring at rest. If a bond fails without
// softening, the contact acts from the end of that step. The energy that the contact stores is subtracted from that
// of the failure event, and is no more than the bond has stored along its normal. If a softening beam breaks, the
// contact replaces the pressure on the beam. If a crack has parted (its faces no longer face each other), the cells
// touch at their present distance without a force. Cells with faces on a material plane touch by these faces.
#pragma once
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"
#include "pairs.hpp"

namespace bondem {

// Initial contact of a pair: whether its two elements touch, and their forces.
struct NewContact {
    bool touches;
    Vector force;  // on the later element [N]
    Vector torque;  // on either, over its radius [N]
};
// Begins the contact of pair k in its present position, with an overlap of at most `pressed` if its stiffness is that of
// the bond.
NewContact begin_pair(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, Index k, double pressed);
// Adds the forces of an initial contact to the row of sums of one of its two elements.
inline void add_new_contact(double *row, bool is_later, double radius, const NewContact &contact) {
    const double sign = is_later ? 1.0 : -1.0;
    for (Index x = 0; x < 3; x++) {
        row[x] += sign * contact.force[x];
        row[4 + x] += radius * contact.torque[x];
    }
}

// Begins the contact of the cells of a broken facet at distance `apart`, or at the present distance if that is less,
// without force and energy. Returns that distance [m].
inline double open_pair(const Moving &all, const ContactPairs &pairs, Index facet, double apart) {
    const Index k = pairs.of_bond(facet);
    const double reach = least(apart, length(branch_of(all.pose.data, pairs, k)));
    pairs.joined(facet) = 0.0;
    pairs.reach(k) = pairs.whole(k) = reach;
    return reach;
}

// Ends the pressure on softening beams that have broken at the beginning of this step.
void release_pressure(const Range &range, const EventLog &log, const SofteningBounds &bounds);
// Begins contact where softening beams have broken at the beginning of this step. The contact replaces their
// pressure, with its energy.
void begin_softened_contacts(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                             const NearPairs &near, const EventLog &log, const ContactSums &to);

}  // namespace bondem
