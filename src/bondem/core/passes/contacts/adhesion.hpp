// Adhesion between spheres that touch or are near, and between spheres and walls: a normal force that depends on the
// present gap only (`laws/adhesion.hpp`). Broken surfaces do not heal: spheres that a bond has joined do not adhere.
#pragma once
#include "../../laws/adhesion.hpp"
#include "../../steps.hpp"
#include "../../tables/contact_tables.hpp"
#include "pairs.hpp"
#include "wall_shapes.hpp"

namespace bondem {

inline Adhesion adhesion_of(const ContactRow &of, double ra, double rb) { return {of.strength, of.reach, ra, rb}; }
inline Adhesion adhesion_of(const ContactConstants &c, const ContactPairs &pairs, Index k) {
    return adhesion_of(law_of(c, pairs, k), c.radius(pairs.first(k)), c.radius(pairs.second(k)));
}
// Writes the adhesion of pair k as a force on its later element [N].
inline void adhere_pair(Index k, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                        const AdheringPairs &of) {
    Vector force = {};
    if (pairs.bond(k) < 0) {
        const Vector d = branch_of(all.pose.data, pairs, k);
        const double distance = length(d);
        force = (-adhesion_of(c, pairs, k).force(distance - pairs.reach(k)) / distance) * d;
    }
    of.force.row<Vector>(k) = force;
}
// Adds the adhesion of pair k to its later or its earlier element.
inline void add_adhesion(const AdheringPairs &of, Index k, bool later, double *row) {
    for (Index x = 0; x < 3; x++) row[x] += later ? of.force(k, x) : -of.force(k, x);
}

// Adds the adhesion of a portion of elements at walls to their sums, and to the loads of the walls.
void adhere_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                     const Walls &walls, const ContactSums &to);
// Adds the energy of adhesion of the pairs of a portion, below 0 [J].
void sum_adhesion_energies(const Range &range, const Moving &all, const ContactConstants &c,
                           const ContactPairs &pairs, const Ledger &ledger);
// Adds the energy of adhesion at walls of a portion of elements, below 0 [J].
void sum_adhesion_at_walls(const Range &range, const Moving &all, const ContactConstants &c, const WallContacts &contacts,
                           const Walls &walls, const Ledger &ledger);

}  // namespace bondem
