// Contributions of contacts to the stresses of elements of the non-local law: the force, at the lever from the centre
// of the element to the point of contact with another element or a wall.
#include "non_local_passes.hpp"

#include "../../registered.hpp"
#include "../contacts/wall_shapes.hpp"
#include "../damage/pipeline.hpp"
#include "touch_levers.hpp"

namespace bondem {
namespace {

// Adds the moment of a force at a lever to the stress of an element, in the frame of the element.
void add_to_stress(const double *pose, const LaggedStresses &stresses, Short p, Vector lever, Vector force) {
    const Quaternion<double> back = inverse(orientation(gather(pose, p)));
    const Stress<double> s = stresses.inverse(p) * symmetric_product(turned_by(back, lever), turned_by(back, force));
    for (Index c = 0; c < 6; c++) stresses.stress(p, c) += s[c];
}

}  // namespace

void add_new_contacts(const Range &, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                      const LaggedStresses &stresses, const EventLog &log) {
    const double *const pose = all.pose.data;
    for_each_event(log, [&](Index bond, Index) {
        const Index k = pairs.of_bond(bond);
        if (k < 0 || pairs.touch(k) != touching) return;
        const TouchLevers lever(c, pairs, k, branch_of(pose, pairs, k));
        const Vector *const memory = &pairs.memory.row<Vector>(k);
        const Vector force = present_loads(all, c, pairs, k, {memory[0], memory[1]}).contact.force;
        add_to_stress(pose, stresses, pairs.first(k), lever.of_first, -force);
        add_to_stress(pose, stresses, pairs.second(k), lever.of_second, force);
    });
}
BONDEM_PASS(add_new_contacts, of_events, "ends motion; still pose; adds stress")

// Adds contacts of pairs to the stresses of the elements of a range, in the order of the pairs.
void add_pair_moments(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                      const NearPairs &near, const LaggedStresses &stresses) {
    const auto mine = [&](Index p) { return range.first <= p && p < range.last; };
    for (Index q = range.first / elements_of_portion; q < near.counts.size(); q++) {
        const Index begin = pairs.start(elements_of_portion * q), end = begin + near.counts(q, 1);
        for (Index e = begin; e < end; e++) {
            const Short k = near.close(e), a = pairs.first(k), b = pairs.second(k);
            if (!(mine(a) || mine(b))) continue;
            const TouchLevers lever(c, pairs, k, branch_of(all.pose.data, pairs, k));
            const Vector force = near.output.row<const Vector>(e);  // on b
            if (mine(a)) add_moment(stresses, a, lever.of_first, -force);
            if (mine(b)) add_moment(stresses, b, lever.of_second, force);
        }
    }
}
BONDEM_PASS(add_pair_moments, of_ranges, "ends pose; adds moment")

void add_wall_moments(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                      const Walls &walls, const LaggedStresses &stresses) {
    for (Index e = contacts.start(range.first); e < contacts.start(range.last); e++)
        if (contacts.touch(e) == touching) {
            const Short p = contacts.element(e);
            const WallSurface at = surface_of(all, c, contacts, walls, e);
            add_moment(stresses, p, (c.radius(p) + at.gap) * at.normal, contacts.output.row<const Vector>(e));
        }
}
BONDEM_PASS(add_wall_moments, of_elements, "own pose; changes moment")

}  // namespace bondem
