// Passes of adhesion between spheres, and between spheres and walls (`adhesion.hpp`).
#include "adhesion.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"

namespace bondem {
namespace {

// An element at a wall, with the adhesion between them.
struct NearWall {
    Short p;
    double radius, gap;  // gap from which adhesion counts [m]
    WallSurface at;
    Adhesion adhesion;

    NearWall(const Moving &all, const ContactConstants &c, const WallContacts &contacts, const Walls &walls, Index e)
        : p(contacts.element(e)), radius(c.radius(p)),
          at(WallPlace(walls, contacts.wall(e)).surface(centre(all.pose.data, p), radius)),
          adhesion(adhesion_of(c.at_wall(p, contacts.wall(e)), radius, radius)) {
        gap = at.gap - contacts.gap(e);
    }
};

}  // namespace

// Finds the adhesion of the near pairs of a portion of elements.
void adhere_pairs(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near,
                  const AdheringPairs &of) {
    const Index begin = pairs.start(range.first), end = begin + near.counts(range.block, 0);
    for (Index e = begin; e < end; e++) adhere_pair(near.near(e), all, c, pairs, of);
}
BONDEM_PASS(adhere_pairs, of_elements, "ends pose")

// Adds adhesion to the elements of a range.
void add_adhesion_loads(const Range &range, const ContactPairs &pairs, const NearPairs &near, const AdheringPairs &of,
                        const ContactSums &to) {
    over_listed_pairs(range, pairs, near.near, [&](Index q) { return near.counts(q, 0); },
                      [&](Short k, Short p, bool later) { add_adhesion(of, k, later, &to.sums(p, 0)); });
}
BONDEM_PASS(add_adhesion_loads, of_ranges, "adds sums")

void adhere_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                     const Walls &walls, const ContactSums &to) {
    for (Index e = contacts.start(range.first); e < contacts.start(range.last); e++) {
        const NearWall near(all, c, contacts, walls, e);
        const double pull = near.adhesion.force(near.gap);
        if (pull == 0.0) continue;
        const Vector n = near.at.normal, f = -pull * n;
        const Vector place = minus(centre(all.pose.data, near.p), near.radius + near.at.gap, n);
        WallLoad &output = contacts.output.row<WallLoad>(e);
        output.force = output.force - f;
        output.normal -= pull;
        output.torque = output.torque - cross(place - WallPlace(walls, contacts.wall(e)).pivot(), f);
        for (Index x = 0; x < 3; x++) to.sums(near.p, x) += f[x];
    }
}
BONDEM_PASS(adhere_at_walls, of_elements, "own pose; changes sums")

void sum_adhesion_energies(const Range &range, const Moving &all, const ContactConstants &c,
                           const ContactPairs &pairs, const Ledger &ledger) {
    add_up(ledger, history_column::contact, pairs.start(range.first), pairs.start(range.last), [&](Index k) {
        if (pairs.bond(k) >= 0) return 0.0;
        return adhesion_of(c, pairs, k).energy(length(branch_of(all.pose.data, pairs, k)) - pairs.reach(k));
    });
}
BONDEM_PASS(sum_adhesion_energies, of_elements, "")

void sum_adhesion_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                           const Walls &walls, const Ledger &ledger) {
    add_up(ledger, history_column::contact, contacts.start(range.first), contacts.start(range.last), [&](Index e) {
        const NearWall near(all, c, contacts, walls, e);
        return near.adhesion.energy(near.gap);
    });
}
BONDEM_PASS(sum_adhesion_at_walls, of_elements, "")

}  // namespace bondem
