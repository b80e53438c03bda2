// Contacts on a GPU. Passes with one thread per listed pair compute the force of the pair. Passes with one thread per
// element add the forces of all its pairs, and compute the forces of walls on the element.
//
// Each step examines every pair of the list. The list is valid until an element or a wall has moved by a given
// distance, the reach of the list. Then the run halts: later passes do nothing until the CPU has made a new list.
#pragma once
#include "../passes/contacts/contact_passes.hpp"
#include "../passes/contacts/face_contacts.hpp"
#include "../passes/contacts/pairs.hpp"
#include "../passes/contacts/wall_shapes.hpp"
#include "record.hpp"

namespace bondem {

// ---- validity of the list

inline void check_travel_of_element(Index p, const DeviceSpan &span, const Moving &all, const Travel &travel) {
    const Vector moved = centre(all.pose.data, Short(p)) - travel.listed.row<const Vector>(p);
    if (!(dot(moved, moved) < travel.reach * travel.reach)) put_shared(span.halted(0), Index(1));
}
inline void check_travel_of_wall(Index w, const DeviceSpan &span, const Travel &travel, const Walls &walls) {
    if (!(travel_of_wall(walls, w, travel.reach) < travel.reach)) put_shared(span.halted(0), Index(1));
}
constexpr auto move_all_walls = once<move_walls>;

// ---- forces

BONDEM_INLINE void press_one(Index k, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                             const NearPairs &near, double dt) {
    const Vector *const past = &pairs.memory.row<Vector>(k);
    const PairLoads<double> loads = present_loads(all, c, pairs, k, {past[0], past[1]}, dt);
    const Vector s = loads.contact.memory.stretch, h = loads.contact.memory.viscous, f = loads.contact.force;
    const Vector t = loads.torque;
    row_at(pairs.memory.data, Short(k)) = {{s.x, s.y, s.z, h.x, h.y, h.z, 0.0, 0.0}};
    row_at(near.output.data, Short(k)) = {{f.x, f.y, f.z, loads.contact.damped, t.x, t.y, t.z, loads.contact.rubbed}};
    pairs.touch(k) = loads.overlap > 0.0 ? touching : parted;
}
inline void press_pair(Index k, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                       const ContactPairs &pairs, const NearPairs &near) {
    if (bonded(pairs, k)) return;
    const Vector d = branch_of(all.pose.data, pairs, k);
    if (dot(d, d) >= pairs.reach(k) * pairs.reach(k) && pairs.touch(k) != touching) {
        leave(pairs, k, dot(d, d));
        return;
    }
    press_one(k, all, c, pairs, near, clock_of(span).dt);
}
// Computes the contact of pair k of a body of cells with cracks: by faces, or as spheres.
inline void press_pair_or_faces(Index k, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                                const ContactPairs &pairs, const NearPairs &near, const FacePairs &faces) {
    faces.close(k) = 0;
    if (bonded(pairs, k)) return;
    const double dt = clock_of(span).dt;
    const PairOf kind = press_faces(all, c, pairs, faces, k, dt);
    faces.close(k) = kind == PairOf::faces;
    if (kind == PairOf::spheres) press_one(k, all, c, pairs, near, dt);
}
// Adds forces of faces on element p: of pairs whose later element it is, then of pairs whose earlier element it is.
inline void add_faces_of_element(Index p, const ContactPairs &pairs, const FacePairs &faces, const ContactSums &to) {
    for_each_pair_of(pairs, faces.earlier_start, faces.earlier, p, [&](Index k, bool later) {
        if (faces.close(k) != 0) add_faces_to(faces, k, later, &to.sums(p, 0));
    });
}
inline bool as_spheres(Byte touch) { return touch == touching || touch == parted; }
// Adds forces of pairs on element p in their order: as the later element of a pair, then as the earlier one.
inline void add_pairs_of_element(Index p, const ContactConstants &c, const ContactPairs &pairs, const EarlierPairs &earlier,
                                 const NearPairs &near, const ContactSums &to) {
    Row<double> sum = {};
    bool loaded = false;
    const double r = c.radius(p);
    for (Index k = pairs.start(p); k < pairs.start(p + 1); k++) {
        if (!as_spheres(pairs.touch(k))) continue;
        const Row<double> &out = row_at(near.output.data, Short(k));
        for (Index x = 0; x < 4; x++) sum.column[x] += out.column[x];
        for (Index x = 4; x < 7; x++) sum.column[x] += r * out.column[x];
        sum.column[7] += out.column[7];
        loaded = true;
    }
    for (Index e = earlier.start(p); e < earlier.start(p + 1); e++) {
        const Short k = earlier.pair(e);
        if (!as_spheres(pairs.touch(k))) continue;
        const Row<double> &out = row_at(near.output.data, k);
        for (Index x = 0; x < 3; x++) {
            sum.column[x] -= out.column[x];
            sum.column[4 + x] += r * out.column[4 + x];
        }
        loaded = true;
    }
    if (loaded) row_at(to.sums.data, Short(p)) = sum;
}
constexpr auto press_walls_on_element = one_element<press_walls>;
constexpr auto add_contact_load = listed_element<add_contact_loads>;
// Sums the forces of elements on wall w, and adds its work.
inline void load_wall(Index w, const DeviceSpan &span, const WallContacts &contacts, const RowOrder &order,
                      const Walls &walls) {
    for (Index e = order.start(w); e < order.start(w + 1); e++) add_to_wall(contacts, order.load(e));
    load_wall_by_sums(contacts, walls, w, 0.5 * clock_of(span).dt);
}
// Adds the second half of the velocity change to free wall e, once its forces are known, and sets its spin.
inline void kick_free_wall(Index e, const DeviceSpan &span, const WallMotions &motions, const Walls &walls) {
    kick_free(motions, walls, e, 0.5 * clock_of(span).dt);
    show_free_spin(walls, motions.free_wall(e));
}

// ---- sums for the guard and the history

// Finds the deepest overlap of pairs and contacts with walls in a portion of elements, over the smaller radius.
inline void measure_overlaps(Index b, const DeviceSpan &span, const Moving &all, const ContactConstants &c,
                             const ContactPairs &pairs, const WallContacts &contacts, const Walls &walls,
                             const Travel &travel) {
    const Range range = portion_of(span, b, span.n);
    double deepest = 0.0;
    for (Index k = pairs.start(range.first); k < pairs.start(range.last); k++)
        if (pairs.touch(k) == touching) {
            const double overlap = pairs.reach(k) - length(branch_of(all.pose.data, pairs, k));
            deepest = most(deepest, overlap / least(c.radius(pairs.first(k)), c.radius(pairs.second(k))));
        }
    deepest = deepest_at_walls(range, all, c, contacts, walls, deepest);
    raise_shared(travel.portion(range.first / elements_of_portion, 2), deepest);
}
constexpr auto sum_portion_of_pairs = portion_of_elements<sum_pair_energies>;
constexpr auto sum_portion_of_faces = portion_of_elements<sum_face_energies>;
constexpr auto sum_portion_at_walls = portion_of_elements<sum_wall_energies>;
constexpr auto count_work_of_walls = once<count_wall_work>;
constexpr auto write_all_walls = once<write_walls>;

}  // namespace bondem
