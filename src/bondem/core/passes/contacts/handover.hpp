// Contact of two elements from which a bond or a facet has gone: the pair was listed, and passed over so far.
//
// What presses the two together acts at once, with the tangential spring at rest, at the end of the step in which the
// bond fails. The contact takes over the energy that it stores.
#pragma once
#include "../../steps.hpp"
#include "../../tables/beam_softening_tables.hpp"
#include "pairs.hpp"

namespace bondem {

// Examines pair k in every step from now on; it keeps its place in the order of the pairs.
void examine(const ContactPairs &pairs, const NearPairs &near, Index k);

// Whether the two elements of a pair touch whose contact begins, and what they do to each other then.
struct BegunContact {
    bool touches;
    Vector force;  // on the later element [N]
    Vector torque;  // on either, over its radius [N]
};
// Begins the contact of pair k as the pair is now.
BegunContact begin_pair(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, Index k);
// Adds it to a row of sums of one of the two elements.
inline void add_begun(double *row, bool is_later, double radius, const BegunContact &begun) {
    const double sign = is_later ? 1.0 : -1.0;
    for (Index x = 0; x < 3; x++) {
        row[x] += sign * begun.force[x];
        row[4 + x] += radius * begun.torque[x];
    }
}

// Begins the contact of the pair of a bond, and adds its force to rows of sums of elements (first_row + element); the
// energy that it takes over [J].
double hand_over(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near, Index bond,
                 double *sums);

// Contact of a facet that carries nothing any more begins at its rest length `apart`, or at the present distance where that
// is less: without a force, and with no energy. Returns that distance [m].
inline double open_pair(const Moving &all, const ContactPairs &pairs, Index facet, double apart) {
    const Index k = pairs.of_bond(facet);
    const double reach = least(apart, length(branch_of(all.pose.data, pairs, k)));
    pairs.joined(facet) = 0.0;
    pairs.reach(k) = reach;
    return reach;
}
// The same, and the pair is examined in every step from now on.
double let_touch(const Moving &all, const ContactPairs &pairs, const NearPairs &near, Index facet, double apart);

// Ends the pressure on beams that soften and have broken at the beginning of this step.
void release_pressure(const Turn &turn, const EventLog &log, const SofteningBounds &bounds);
// Begins contact where beams that soften have broken at the beginning of this step: its energy is that of the
// pressure, which it replaces.
void begin_softened_contacts(const Turn &turn, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                             const NearPairs &near, const EventLog &log, const ContactSums &to);

}  // namespace bondem
