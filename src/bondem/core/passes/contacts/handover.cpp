#include "handover.hpp"

#include "../../registered.hpp"
#include "../damage/pipeline.hpp"

namespace bondem {

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

BegunContact begin_pair(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, Index k) {
    for (Index x = 0; x < 8; x++) pairs.memory(k, x) = 0.0;
    pairs.touch(k) = separate;
    const Vector d = branch_of(all.pose.data, pairs, k);
    if (!(length(d) < pairs.reach(k))) return {false, {}, {}};
    const Short a = pairs.first(k), b = pairs.second(k);
    const Motion<double> of_a(gather(all.motion.data, a)), of_b(gather(all.motion.data, b));
    const Spheres2<double> pair(c.radius(a), c.radius(b), pairs.reach(k), d, of_a, of_b);
    PairLoads<double> loads;
    const ContactRow &of = c.of(a, b);
    with_law(c, of, [&](auto law) { loads = pair_loads(law, of, pair, pairs.own(k), ContactMemory<double>{}, 0.0); });
    const ContactMemory<double> &memory = loads.contact.memory;
    pairs.memory.row<Vector>(k) = memory.stretch;
    (&pairs.memory.row<Vector>(k))[1] = memory.viscous;
    pairs.touch(k) = touching;
    return {true, loads.contact.force, loads.torque};
}

double hand_over(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near, Index bond,
                 double *sums) {
    const Index k = pairs.of_bond(bond);
    if (k < 0) return 0.0;
    examine(pairs, near, k);
    const BegunContact begun = begin_pair(all, c, pairs, k);
    if (!begun.touches) return 0.0;
    const Short a = pairs.first(k), b = pairs.second(k);
    add_begun(sums + 8 * uint64_t(a), false, c.radius(a), begun);
    add_begun(sums + 8 * uint64_t(b), true, c.radius(b), begun);
    return pair_energy(all.pose.data, c, pairs, k);
}

double let_touch(const Moving &all, const ContactPairs &pairs, const NearPairs &near, Index facet, double apart) {
    const double reach = open_pair(all, pairs, facet, apart);
    examine(pairs, near, pairs.of_bond(facet));
    return reach;
}

// Begins contact where beams have broken in this step, on the sums that are kept for their ends.
void begin_contacts(const Turn &, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                    const NearPairs &near, const EventLog &log, const Postponed &postponed) {
    for_each_event(log, [&](Index bond, Index event) {
        take_over(log, event, hand_over(all, c, pairs, near, bond, postponed.kept.data));
    });
}
BONDEM_PASS(begin_contacts, serial)

void release_pressure(const Turn &, const EventLog &log, const SofteningBounds &bounds) {
    for_each_event(log, [&](Index bond, Index) { bounds.press(bond) = 0.0; });
}
BONDEM_PASS(release_pressure, serial)

void begin_softened_contacts(const Turn &, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                             const NearPairs &near, const EventLog &log, const ContactSums &to) {
    for_each_event(log, [&](Index bond, Index) { hand_over(all, c, pairs, near, bond, to.sums.data); });
}
BONDEM_PASS(begin_softened_contacts, serial)

}  // namespace bondem
