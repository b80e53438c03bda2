// Passes that begin the contact of elements whose bond or facet has failed in a step (`handover.hpp`).
#include "handover.hpp"

#include "../../exact_sum.hpp"
#include "../../registered.hpp"
#include "../cracks/crack_rows.hpp"
#include "../damage/pipeline.hpp"
#include "face_contacts.hpp"

namespace bondem {

NewContact begin_pair(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, Index k, double pressed) {
    for (Index x = 0; x < 8; x++) pairs.memory(k, x) = 0.0;
    const double distance = length(branch_of(all.pose.data, pairs, k));
    if (pairs.own(k) > 0.0) pairs.reach(k) = least(pairs.reach(k), distance + pressed);
    if (!(distance < pairs.reach(k))) {
        leave(pairs, k, distance * distance);
        return {false, {}, {}};
    }
    const PairLoads<double> loads = present_loads(all, c, pairs, k, {});
    const ContactMemory<double> &memory = loads.contact.memory;
    pairs.memory.row<Vector>(k) = memory.stretch;
    (&pairs.memory.row<Vector>(k))[1] = memory.viscous;
    pairs.touch(k) = touching;
    return {true, loads.contact.force, loads.torque};
}

namespace {

// Inserts pair k into the ascending list of near pairs, so that every step evaluates it.
void examine(const ContactPairs &pairs, const NearPairs &near, Index k) {
    const Index portion = pairs.second(k) / elements_of_portion, begin = pairs.start(portion * elements_of_portion);
    Index e = begin + near.counts(portion, 0);
    const Index end = e;
    while (e > begin && near.near(e - 1) > k) e--;
    if (e > begin && near.near(e - 1) == k) return;
    for (Index q = end; q > e; q--) near.near(q) = near.near(q - 1);
    near.near(e) = Short(k);
    near.counts(portion, 0)++;
}

// Begins the contact of the pair of a bond, and adds its force to rows of sums of elements; returns the
// energy that moves to the contact [J].
double hand_over(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near, Index bond,
                 double pressed, double *sums) {
    const Index k = pairs.of_bond(bond);
    if (k < 0) return 0.0;
    examine(pairs, near, k);
    const NewContact contact = begin_pair(all, c, pairs, k, pressed);
    if (!contact.touches) return 0.0;
    const Short a = pairs.first(k), b = pairs.second(k);
    add_new_contact(sums + 8 * uint64_t(a), false, c.radius(a), contact);
    add_new_contact(sums + 8 * uint64_t(b), true, c.radius(b), contact);
    return pair_energy(all.pose.data, c, pairs, k);
}

}  // namespace

// Begins contact where beams have broken in this step, on the sums that are kept for their ends.
void begin_contacts(const Range &, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                    const NearPairs &near, const EventLog &log, const Postponed &postponed) {
    if (!any_event(log)) return;
    ExactSum stored = {};
    for_each_event(log, [&](Index bond, Index event) {
        const double energy = hand_over(all, c, pairs, near, bond, log.pressed(event), postponed.sum.data);
        log.event(event, event_column::energy) -= energy;
        stored.add(energy);
    });
    log.released(0) -= stored.value();
}
BONDEM_PASS(begin_contacts, of_events, "ends motion; still pose; adds sum")

void release_pressure(const Range &, const EventLog &log, const SofteningBounds &bounds) {
    for_each_event(log, [&](Index bond, Index) { bounds.press(bond) = 0.0; });
}
BONDEM_PASS(release_pressure, of_events, "")

void begin_softened_contacts(const Range &, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                             const NearPairs &near, const EventLog &log, const ContactSums &to) {
    for_each_event(log, [&](Index bond, Index event) {
        hand_over(all, c, pairs, near, bond, log.pressed(event), to.sums.data);
    });
}
BONDEM_PASS(begin_softened_contacts, of_events, "ends motion pose; adds sums")

// Begins to evaluate the pairs of cells whose cracks have parted in this step.
void touch_parted_faces(const Range &, const Moving &all, const ContactPairs &pairs, const NearPairs &near,
                        const CohesiveCracks &cracks, const CrackLists &lists, const PartedReach &reach) {
    for (Index e = 0; e < lists.size(list_count::parted); e++) {
        const Index k = lists.parted(e);
        shape_of(cracks, k).top = reach.apart(k) = open_pair(all, pairs, k, reach.apart(k));
        examine(pairs, near, pairs.of_bond(k));
    }
}
BONDEM_PASS(touch_parted_faces, of_events, "ends pose")

// Begins the contact of faces that part in this step.
void begin_face_contacts(const Range &, const Moving &all, const ContactPairs &pairs, const NearPairs &near,
                         const FacePairs &faces, const CrackLists &lists, const EventLog &log) {
    const Index count = lists.size(list_count::parted);
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
            for_each_pair_of(pairs, faces.earlier_start, faces.earlier, a, on);
            for_each_pair_of(pairs, faces.earlier_start, faces.earlier, b, on);
        });
    };
    over_parted([&](Index k, Short, Short, Index pair) { mark_parting(pairs, faces, k, pair); });
    constexpr double unknown = infinity;
    over_all_pairs([&](Index k, bool) { faces.gained(k) = unknown; });
    ExactSum &gained = exact_sum(faces.gained_sum, 0);
    over_all_pairs([&](Index k, bool) {
        if (faces.gained(k) != unknown) return;
        faces.gained(k) = begin_by_faces(all, pairs, faces, k);
        gained.add(faces.gained(k));
        if (!bonded(pairs, k)) examine(pairs, near, k);
    });
    log.released(0) -= gained.take();
    over_parted([&](Index k, Short a, Short b, Index) {
        if (has_faces(faces, k)) faces.open(k) = faces.faced(a) = faces.faced(b) = 1;
    });
}
BONDEM_PASS(begin_face_contacts, of_events, "")

}  // namespace bondem
