// Contacts of pairs of elements. A pass computes force and memory (stretch of the tangential spring, and force of the
// dashpots) of each touching pair; other passes add the forces to the elements.
//
// Most pairs of the list are bonded, or too far apart to touch before distances are measured again. Only the others
// are evaluated in every step, as many at once as a vector register has lanes. Forces are summed in a fixed order.
#include "contact_passes.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "face_contacts.hpp"
#include "pairs.hpp"

namespace bondem {
namespace {

// Largest relative error of a distance by rounding.
constexpr double rounding = 1e-9;

// Lists the pairs of a portion that may touch before an element has moved by `width`, and those that do; `outer` is
// the distance within which a pair may touch otherwise than as spheres [m].
template <class Outer>
void list_near(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
               const NearPairs &near, const Travel &travel, Outer outer) {
    const Index begin = pairs.start(range.first), end = pairs.start(range.last);
    Index count = 0;
    double deepest = 0.0;
    for (Index k = begin; k < end; k++) {
        if (bonded(pairs, k)) continue;
        const Vector d = branch_of(all.pose.data, pairs, k);
        const double square = dot(d, d), reach = (1.0 + rounding) * pairs.reach(k);
        const double limit = most(reach, outer(k)) + near.beyond + 2.0 * near.width;
        near.near(begin + count) = Short(k);
        count += (square <= limit * limit) | (pairs.touch(k) != separate);
        if (square < reach * reach && pairs.touch(k) != facing) {
            const double smaller = least(c.radius(pairs.first(k)), c.radius(pairs.second(k)));
            deepest = most(deepest, (reach - root(square)) / smaller);
        }
    }
    near.counts(range.block, 0) = count;
    double farthest = 0.0;
    for (Index p = range.first; p < range.last; p++) {
        const Vector x = centre(all.pose.data, Short(p)), moved = x - travel.listed.row<const Vector>(p);
        farthest = most(farthest, dot(moved, moved));
        travel.measured.row<Vector>(p) = x;
    }
    travel.portion(range.block, 1) = farthest;
    travel.portion(range.block, 2) = most(travel.portion(range.block, 2), deepest);
}

// Finds the near pairs that touch, or did a step ago; returns their number.
Index find_close(const Range &range, const Moving &all, const ContactPairs &pairs, const NearPairs &near) {
    const Index begin = pairs.start(range.first), count = near.counts(range.block, 0);
    Index found = 0;
    for (Index e = begin; e < begin + count; e++) {
        const Short k = near.near(e);
        const Vector d = branch_of(all.pose.data, pairs, k);
        const double reach = pairs.reach(k), square = dot(d, d);
        const bool off = (square >= reach * reach) & (pairs.touch(k) != touching);
        if (off) leave(pairs, k, square);
        near.close(begin + found) = k;
        found += !off;
    }
    near.counts(range.block, 1) = found;
    return found;
}

// Finds near pairs that touch as spheres in bodies with cracks, returns their number, and computes pairs of faces.
Index find_close(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                 const NearPairs &near, const FacePairs &faces) {
    const Index begin = pairs.start(range.first), count = near.counts(range.block, 0);
    Index found = 0, faced = 0;
    for (Index e = begin; e < begin + count; e++) {
        const Short k = near.near(e);
        const PairOf kind = press_faces(all, c, pairs, faces, k, range.clock.dt);
        near.close(begin + found) = k;
        found += kind == PairOf::spheres;
        faces.close(least(begin + faced, pairs.start(range.last) - 1)) = k;
        faced += kind == PairOf::faces;
    }
    near.counts(range.block, 1) = found;
    faces.count(range.block) = faced;
    return found;
}

#if defined(BONDEM_LANES)

// Consecutive pairs of a list; the last pair fills an incomplete group.
struct SeveralPairs {
    Short pair[lanes], first[lanes], second[lanes], place[lanes];

    BONDEM_INLINE SeveralPairs(const ContactPairs &pairs, const NearPairs &near, Index e, Index end) {
        for (int n = 0; n < lanes; n++) {
            place[n] = Short(least(e + n, end - 1));
            pair[n] = near.close.data[place[n]];
            first[n] = pairs.first.data[pair[n]];
            second[n] = pairs.second.data[pair[n]];
        }
    }
};

// Parameters of the laws of several pairs.
struct SeveralLaws {
    Lanes modulus, soft, friction, damping;

    BONDEM_INLINE SeveralLaws(const ContactConstants &c, const SeveralPairs &who) {
        for (int n = 0; n < lanes; n++) {
            const ContactRow &of = c.of(who.first[n], who.second[n]);
            modulus[n] = of.modulus, soft[n] = of.soft, friction[n] = of.friction, damping[n] = of.damping;
        }
    }
};

template <class Law, class Numbers>
BONDEM_INLINE void press(const Law &law, const Numbers &of, const SeveralPairs &who, const Moving &all,
                         const ContactConstants &c, const ContactPairs &pairs, const NearPairs &near, double dt) {
    using Three = Vector3<Lanes>;
    const double *const pose = all.pose.data, *const motion = all.motion.data, *const radius = c.radius.data;
    const Three d = branch(gather(pose, who.first), gather(pose, who.second), pairs.period.data);
    const Motion<Lanes> a(gather(motion, who.first)), b(gather(motion, who.second));
    const Lanes ra = number_at(radius, 1, 0, who.first), rb = number_at(radius, 1, 0, who.second);
    const Spheres2<Lanes> pair(ra, rb, number_at(pairs.reach.data, 1, 0, who.pair), d, a, b);
    const Row<Lanes> past = gather(pairs.memory.data, who.pair);
    const ContactMemory<Lanes> memory = {{past.column[0], past.column[1], past.column[2]},
                                         {past.column[3], past.column[4], past.column[5]}};
    const PairLoads<Lanes> loads = pair_loads(law, of, pair, number_at(pairs.own.data, 1, 0, who.pair), memory, dt);
    const Three s = loads.contact.memory.stretch, h = loads.contact.memory.viscous;
    const Three f = loads.contact.force, t = loads.torque;
    const Lanes zero = {};
    scatter(pairs.memory.data, who.pair, {{s.x, s.y, s.z, h.x, h.y, h.z, zero, zero}});
    scatter(near.output.data, who.place, {{f.x, f.y, f.z, loads.contact.damped, t.x, t.y, t.z, loads.contact.rubbed}});
    for (int n = 0; n < lanes; n++) pairs.touch.data[who.pair[n]] = loads.overlap[n] > 0.0 ? touching : parted;
}

void press_close(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                 const NearPairs &near, Index count) {
    const Index begin = pairs.start(range.first), end = begin + count;
    if (c.between.shape[0] == 1) {
        const ContactRow one = c.of(0, 0);
        with_law(c, one, [&](auto law) {
            for (Index e = begin; e < end; e += lanes)
                press(law, one, SeveralPairs(pairs, near, e, end), all, c, pairs, near, range.clock.dt);
        });
        return;
    }
    for (Index e = begin; e < end; e += lanes) {
        const SeveralPairs who(pairs, near, e, end);
        const SeveralLaws of(c, who);
        with_law(c, of, [&](auto law) { press(law, of, who, all, c, pairs, near, range.clock.dt); });
    }
}

#endif

}  // namespace

#if defined(BONDEM_LANES)

// Finds forces and memory of the pairs of a portion of elements; renews the list of near pairs after large motions.
void press_pairs(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                 const NearPairs &near, const Travel &travel) {
    if (measures_anew(range, near, travel)) list_near(range, all, c, pairs, near, travel, [](Index) { return 0.0; });
    press_close(range, all, c, pairs, near, find_close(range, all, pairs, near));
}
BONDEM_PASS(press_pairs, of_elements, "ends motion pose; writes measured")

// Finds forces and memory of the pairs of a portion of cells with cracks, which touch by faces too.
void press_pairs_and_faces(const Range &range, const Moving &all, const ContactConstants &c,
                           const ContactPairs &pairs, const NearPairs &near, const Travel &travel,
                           const FacePairs &faces) {
    if (measures_anew(range, near, travel))
        list_near(range, all, c, pairs, near, travel, [&](Index k) { return outer_reach(pairs, faces, k); });
    press_close(range, all, c, pairs, near, find_close(range, all, c, pairs, near, faces));
}
BONDEM_PASS(press_pairs_and_faces, of_elements, "ends faced motion pose; writes measured")

// Adds forces of pairs to the elements of a range, in the order of the pairs.
void add_pair_loads(const Range &range, const ContactConstants &c, const ContactPairs &pairs,
                    const NearPairs &near, const ContactSums &to) {
    const auto mine = [&](Short p) { return range.first <= p && p < range.last; };
    const auto add = [&](Short p, Four force, Four torque, Four signs, double losses) __attribute__((always_inline)) {
        const double r = c.radius(p);
        const Four arms = {r, r, r, losses};
        FourInMemory *const sum = &to.sums.row<FourInMemory>(p);
        sum[0] = sum[0] + signs * force;
        sum[1] = sum[1] + arms * torque;
    };
    for (Index q = range.first / elements_of_portion; q < near.counts.size(); q++) {
        const Index begin = pairs.start(elements_of_portion * q), end = begin + near.counts(q, 1);
        for (Index e = begin; e < end; e++) {
            const Short k = near.close(e), a = pairs.first(k), b = pairs.second(k);
            const FourInMemory *const out = &near.output.row<FourInMemory>(e);
            const Four force = out[0], torque = out[1];
            if (mine(a)) add(a, force, torque, Four{-1.0, -1.0, -1.0, 0.0}, 0.0);
            if (mine(b)) add(b, force, torque, Four{1.0, 1.0, 1.0, 1.0}, 1.0);
        }
    }
}
BONDEM_PASS(add_pair_loads, of_ranges, "adds sums")

#endif

void add_contact_loads(const Range &range, const Moving &all, const StepBlocks &blocks, const ContactSums &contacts) {
    for (Index e = range.first; e < range.last; e++) {
        const Short p = range.element[e];
        Row<double> &load = row_at(contacts.sums.data, p), &sum = row_at(blocks.sums.data, range.row[e]);
        bool loaded = false;
        for (double number : load.column) loaded |= number != 0.0;
        if (!loaded) continue;  // as most elements of a body
        for (Index c = 0; c < 3; c++) {
            sum.column[c] += load.column[c];
            sum.column[4 + c] += load.column[4 + c];
        }
        all.loss(p, 0) += load.column[3];
        all.loss(p, 2) += load.column[7];
        load = {};
    }
}
BONDEM_PASS(add_contact_loads, elements_of_blocks, "changes ContactSums.sums StepBlocks.sums loss")

void sum_pair_energies(const Range &range, const Moving &all, const ContactConstants &law, const ContactPairs &pairs,
                       const Ledger &ledger) {
    add_up(ledger, history_column::contact, pairs.start(range.first), pairs.start(range.last),
           [&](Index k) { return pairs.touch(k) == touching ? pair_energy(all.pose.data, law, pairs, k) : 0.0; });
}
BONDEM_PASS(sum_pair_energies, of_elements, "")

}  // namespace bondem
