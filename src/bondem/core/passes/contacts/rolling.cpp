// Passes of the resistance to rolling and twisting (`rolling.hpp`): moments on elements in contact with each other or
// with walls, and stored energies.
#include "rolling.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"

namespace bondem {

// Finds moments and memory of the springs of rolling of close pairs in a portion of elements.
void roll_pairs(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near,
                const RolledPairs &of) {
    const Index begin = pairs.start(range.first), end = begin + near.counts(range.block, 1);
    for (Index e = begin; e < end; e++)
        roll_pair(all, c, pairs, of, near.close(e), near.output.row<const Vector>(e), range.clock.dt);
}
BONDEM_PASS(roll_pairs, of_elements, "ends motion pose")

// Adds moments of resistance to rolling to the elements of a range.
void add_rolling_loads(const Range &range, const ContactPairs &pairs, const NearPairs &near, const RolledPairs &of,
                       const ContactSums &to) {
    over_listed_pairs(range, pairs, near.close, [&](Index q) { return near.counts(q, 1); },
                      [&](Short k, Short p, bool later) { add_rolling(of, k, later, &to.sums(p, 0)); });
}
BONDEM_PASS(add_rolling_loads, of_ranges, "adds sums")

void roll_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                   const Walls &walls, const RolledWalls &of, const ContactSums &to) {
    const double dt = range.clock.dt;
    for (Index e = contacts.start(range.first); e < contacts.start(range.last); e++) {
        Vector &rolled = of.rolled.row<Vector>(e);
        const bool touches = contacts.touch(e) == touching;
        if (!touches && dot(rolled, rolled) == 0.0) continue;
        const Short p = contacts.element(e);
        const WallPlace wall(walls, contacts.wall(e));
        const Vector x = centre(all.pose.data, p);
        const double radius = c.radius(p);
        const Motion<double> moving(gather(all.motion.data, p));
        const SeenFromWall seen = seen_from(wall, x, radius, moving, {rolled, {}}, dt);
        const Vector n = wall.surface(x, radius).normal;
        WallLoad &output = contacts.output.row<WallLoad>(e);
        const ContactRow &law = c.at_wall(p, contacts.wall(e));
        const RollingContact at = {rolling_stiffness_at_wall(c, law, radius), radius, touches ? output.normal : 0.0, n,
                                   seen.before.normal, seen.now.spin, seen.last.spin, 0.5 * dot(seen.now.spin, n)};
        const RollingLoads loads = rolling_loads(at, law, seen.memory.stretch, dt);
        rolled = loads.rolled;
        output.torque = output.torque - loads.moment;
        for (Index k = 0; k < 3; k++) to.sums(p, 4 + k) += loads.moment[k];
        to.sums(p, load_column::rubbed) += loads.rubbed;
    }
}
BONDEM_PASS(roll_at_walls, of_elements, "own motion; changes sums")

void sum_rolling_energies(const Range &range, const ContactConstants &c, const ContactPairs &pairs, const RolledPairs &of,
                          const Ledger &ledger) {
    add_up(ledger, history_column::contact, pairs.start(range.first), pairs.start(range.last), [&](Index k) {
        const Vector rolled = of.rolled.row<const Vector>(k);
        return pairs.touch(k) == touching ? 0.5 * rolling_stiffness(c, pairs, k) * dot(rolled, rolled) : 0.0;
    });
}
BONDEM_PASS(sum_rolling_energies, of_elements, "")

void sum_rolling_at_walls(const Range &range, const ContactConstants &c, const WallContacts &contacts, const RolledWalls &of,
                          const Ledger &ledger) {
    add_up(ledger, history_column::contact, contacts.start(range.first), contacts.start(range.last), [&](Index e) {
        const Vector rolled = of.rolled.row<const Vector>(e);
        const Short p = contacts.element(e);
        if (contacts.touch(e) != touching) return 0.0;
        return 0.5 * rolling_stiffness_at_wall(c, c.at_wall(p, contacts.wall(e)), c.radius(p)) * dot(rolled, rolled);
    });
}
BONDEM_PASS(sum_rolling_at_walls, of_elements, "")

}  // namespace bondem
