// Contact of cells by the faces of material planes, such as joints.
//
// A facet of a material plane has a face on each of its two cells. When its crack is broken and these faces no longer
// face each other, they have parted: the facet no longer joins the cells. Each face may then touch an opposite
// cracked face of a cell that no facet joins to its own. A pair of faces has the weight ½ for each face that has
// parted. A face that has not parted is also loaded by its own crack. Two cells touch by one pair of faces at a time:
// the pair with the largest common area, until it separates. Cells with opposite cracked faces do not touch as
// spheres, which would protrude from the plane.
//
// If faces overlap already when they may first touch, this initial overlap causes no force. Faces in one plane of the
// reference, such as those of a joint, are an exception, and take over the pressure of facets that part. As the joint
// slides, the next faces are found before they overlap. The choice of faces does not depend on when lists of contacts
// are made.
#pragma once
#include "../../laws/crack.hpp"
#include "../../laws/face_contact.hpp"
#include "../../steps.hpp"
#include "../../tables/crack_tables.hpp"
#include "pairs.hpp"

namespace bondem {

// Columns of the memory of a pair of faces: the overlap u0 with which it began [m], and kn a step ago [N/m].
constexpr Index began_at = 6, stiff_before = 7;
// Cosine of the largest angle between the branch of two cells and the normal of a face that faces the other cell.
constexpr double least_ahead = 0.5;
// Largest 1 - g²/R² (`laws/face_contact.hpp`) at which faces in one plane begin to touch without an overlap u0.
constexpr double least_share = 0.01;

// The two facets by whose faces a pair touches, coded as one number.
struct ChosenFaces {
    Index first, second;

    explicit ChosenFaces(double number)
        : first(Index(number) % facets), second(Index(number) / facets - 1) {}
    ChosenFaces(Index first, Index second) : first(first), second(second) {}
    double number() const { return double((second + 1) * facets + first); }

  private:
    static constexpr Index facets = Index(1) << 26;
};

// True if cells may touch by the faces of facet k: it belongs to a material plane and has cracked.
inline bool has_faces(const FacePairs &of, Index k) { return of.listed(k) != 0 && of.plane(k) != 0.0; }
// Calls on(facet) for the cracked facets of material planes of cell p.
template <class On> inline void over_cracked_faces(const FacePairs &of, Short p, On on) {
    for_each_bond_of(of, p, [&](Index k, bool) {
        if (has_faces(of, k)) on(k);
    });
}
// The outward normal of the face of facet k on cell p in the reference [-].
inline Vector outward_normal(const FacePairs &of, Index k, Short p) {
    const double sign = of.j(k) == p ? -1.0 : 1.0;
    return {sign * of.normal(0, k), sign * of.normal(1, k), sign * of.normal(2, k)};
}
inline CellFace cell_face(const FacePairs &of, Index k, Short p, Quaternion<double> turned) {
    const Array<const int32_t, 2> &lever = of.j(k) == p ? of.lever_j : of.lever_i;
    const Vector arm = {of.pitch(0) * lever(0, k), of.pitch(1) * lever(1, k), of.pitch(2) * lever(2, k)};
    return {turned_by(turned, arm), turned_by(turned, outward_normal(of, k, p)), of.area(k), of.k(k) / of.area(k)};
}
inline double weight_of(const FacePairs &of, ChosenFaces e) {
    return 0.5 * ((of.open(e.first) != 0) + (of.open(e.second) != 0));
}

// Two cells of a pair in space.
struct TwoCells {
    Short p, q;
    Quaternion<double> a, b;
    Vector branch;  // [m]

    TwoCells(const Moving &all, const ContactPairs &pairs, Index k)
        : p(pairs.first(k)), q(pairs.second(k)), a(orientation(gather(all.pose.data, p))),
          b(orientation(gather(all.pose.data, q))), branch(branch_of(all.pose.data, pairs, k)) {}
    // Two cells of a pair in the reference.
    static TwoCells in_reference(const Moving &all, const ContactPairs &pairs, Index k) {
        TwoCells cells(all, pairs, k);
        cells.a = cells.b = {1.0, 0.0, 0.0, 0.0};
        const Vector d = all.rest.row<const Vector>(cells.q) - all.rest.row<const Vector>(cells.p);
        cells.branch = over_nearest_image(d, pairs.period.data);
        return cells;
    }
    TwoFaces faces(const FacePairs &of, ChosenFaces e) const {
        return {cell_face(of, e.first, p, a), cell_face(of, e.second, q, b), branch};
    }
};
// True if two faces face each other.
inline bool face_each_other(const TwoFaces &at) {
    const double ahead = least_ahead * length(at.branch);
    return dot(at.a.normal, at.branch) > ahead && dot(at.b.normal, at.branch) < -ahead &&
           dot(at.a.normal, at.b.normal) < -least_facing;
}
// True if two faces lie in one plane in the reference, but for rounding.
inline bool in_one_plane(const Moving &all, const ContactPairs &pairs, const FacePairs &of, Index k, ChosenFaces e) {
    constexpr double rounding = 1e-6;
    const TwoFaces at = TwoCells::in_reference(all, pairs, k).faces(of, e);
    return dot(at.a.normal, at.b.normal) < rounding - 1.0 && at.overlap * at.overlap < rounding * rounding * at.a.area;
}

// Cracked faces of two cells: whether any face each other, and the parted ones with the largest overlap.
struct FacedCells {
    bool facing;
    double number, area;  // of the faces chosen, 0 where none overlap
};
inline FacedCells faced_cells(const FacePairs &of, const TwoCells &cells) {
    const Vector from_a = turned_by(inverse(cells.a), cells.branch), from_b = turned_by(inverse(cells.b), cells.branch);
    const double ahead = least_ahead * length(cells.branch);
    FacedCells found = {};
    over_cracked_faces(of, cells.p, [&](Index e) {
        if (!(dot(outward_normal(of, e, cells.p), from_a) > ahead)) return;
        const CellFace face = cell_face(of, e, cells.p, cells.a);
        over_cracked_faces(of, cells.q, [&](Index o) {
            if (!(dot(outward_normal(of, o, cells.q), from_b) < -ahead)) return;
            const TwoFaces at(face, cell_face(of, o, cells.q, cells.b), cells.branch);
            if (!(dot(at.a.normal, at.b.normal) < -least_facing)) return;
            found.facing = true;
            const double area = weight_of(of, {e, o}) * at.area();
            if (at.overlap > 0.0 && area > found.area) {
                found.area = area;
                found.number = ChosenFaces(e, o).number();
            }
        });
    });
    return found;
}

// Distance within which pair k may touch by faces, 0 where none of its cells has faces that have parted [m].
inline double outer_reach(const ContactPairs &pairs, const FacePairs &of, Index k) {
    const Short a = pairs.first(k), b = pairs.second(k);
    return (of.faced(a) | of.faced(b)) != 0 ? of.outer(a) + of.outer(b) : 0.0;
}
// Contact of the two faces by which pair k touches; zero if it touches by none.
inline FaceLoads chosen_loads(const Moving &all, const ContactPairs &pairs, const FacePairs &of, Index k) {
    if (of.chosen(k) == 0.0) return {};
    const ChosenFaces e(of.chosen(k));
    return face_loads(TwoCells(all, pairs, k).faces(of, e), weight_of(of, e), pairs.memory(k, began_at));
}

// Writes forces and memory of the faces of pair k; `lost` is the elastic energy of a contact that ends, a loss [J].
inline void press_met(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const FacePairs &of, Index k,
                      const FaceLoads &met, double lost, double dt) {
    const Short a = pairs.first(k), b = pairs.second(k);
    double *const memory = &pairs.memory(k, 0), *const out = &of.output(k, 0);
    const Vector s = {memory[0], memory[1], memory[2]}, viscous = {memory[3], memory[4], memory[5]};
    const ContactRow &law = c.of(a, b);
    Vector f = {}, on_a = {}, on_b = {};
    ContactLoads<double> loads = {};
    if (met.kn > 0.0) {
        const Motion<double> of_a(gather(all.motion.data, a)), of_b(gather(all.motion.data, b));
        const Vector n = met.normal, arm = met.point - branch_of(all.pose.data, pairs, k);
        const Meeting<double> now = {n, of_b.v - of_a.v + cross(of_b.w, arm) - cross(of_a.w, met.point)};
        const double overlap = met.pressed / met.kn, mass = 1.0 / (of_a.m + of_b.m);
        with_law(c, law, [&](auto of_law) {
            const auto spring = of_law.between(met.kn, c.radius(a), c.radius(b), overlap);
            loads = contact_loads<false>(contact_stiffness(spring, memory[stiff_before], law.soft, mass), law.friction, overlap, now,
                                  now, 0.5 * dot(of_a.w + of_b.w, n), {s, viscous}, dt);
        });
        const Vector rest = minus(loads.force, met.pressed, n);
        f = met.force + rest;
        on_a = met.torque_a - cross(met.point, rest);
        on_b = met.torque_b + cross(arm, rest);
    } else {
        loads.rubbed = lost + 0.5 * law.soft * memory[stiff_before] * dot(s, s);
    }
    const Vector stretch = loads.memory.stretch, damps = loads.memory.viscous;
    for (Index x = 0; x < 3; x++) {
        memory[x] = stretch[x], memory[3 + x] = damps[x];
        out[x] = f[x], out[4 + x] = on_b[x], out[8 + x] = on_a[x];
    }
    out[3] = loads.damped, out[7] = loads.rubbed;
    memory[stiff_before] = met.kn;
}

// Kind of contact of pair k, which no facet joins, in this step; contact of faces is computed.
enum class PairOf { nothing, spheres, faces };
inline PairOf press_faces(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const FacePairs &of,
                          Index k, double dt) {
    Byte &touch = pairs.touch(k);
    if (touch == touching) return PairOf::spheres;
    const Vector d = branch_of(all.pose.data, pairs, k);
    const double square = dot(d, d), outer = outer_reach(pairs, of, k);
    const bool within = square < pairs.reach(k) * pairs.reach(k), had = touch == facing;
    double *const memory = &pairs.memory(k, 0), &chosen = of.chosen(k);
    if (memory[stiff_before] > 0.0) {
        const ChosenFaces e(chosen);
        const TwoFaces at = TwoCells(all, pairs, k).faces(of, e);
        const bool lost = !face_each_other(at);
        const FaceLoads met = face_loads(at, weight_of(of, e), memory[began_at]);
        press_met(all, c, pairs, of, k, lost ? FaceLoads{} : met, met.energy, dt);
        if (lost) chosen = 0.0;
        return PairOf::faces;
    }
    if (had || within || square < outer * outer) {
        const TwoCells cells(all, pairs, k);
        const FacedCells now = faced_cells(of, cells);
        if (now.number != chosen) {
            chosen = now.number;
            memory[began_at] = 0.0;
            if (chosen != 0.0) {
                const ChosenFaces e(chosen);
                const TwoFaces at = cells.faces(of, e);
                if (at.share > least_share || !in_one_plane(all, pairs, of, k, e)) memory[began_at] = at.overlap;
            }
        }
        if (now.facing && (within || chosen != 0.0)) {
            touch = facing;
            pairs.reach(k) = pairs.whole(k);
            const FaceLoads met = chosen_loads(all, pairs, of, k);
            if (!(met.kn > 0.0)) return PairOf::nothing;
            press_met(all, c, pairs, of, k, met, 0.0, dt);
            return PairOf::faces;
        }
        if (had) {
            touch = within ? late : separate;
            if (within) pairs.reach(k) = root(square);
            return PairOf::nothing;
        }
    }
    if (within) return PairOf::spheres;
    leave(pairs, k, square);
    return PairOf::nothing;
}

// Elastic energy of a pair that touches by faces [J].
inline double face_energy(const Moving &all, const ContactConstants &c, const ContactPairs &pairs, const FacePairs &of,
                          Index k) {
    const Vector s = pairs.memory.row<const Vector>(k);
    return chosen_loads(all, pairs, of, k).energy + 0.5 * law_of(c, pairs, k).soft * pairs.memory(k, stiff_before) * dot(s, s);
}
// Adds forces of the faces of pair k to a row of sums of its later or its earlier cell.
inline void add_faces_to(const FacePairs &of, Index k, bool later, double *row) {
    const double *const out = &of.output(k, 0);
    for (Index x = 0; x < 3; x++) {
        row[x] += later ? out[x] : -out[x];
        row[4 + x] += later ? out[4 + x] : out[8 + x];
    }
    if (later) row[3] += out[3], row[7] += out[7];
}

// Marks the faces of facet k that part in this step, and their cells.
inline void mark_parting(const ContactPairs &pairs, const FacePairs &of, Index k, Index pair) {
    if (!has_faces(of, k)) return;
    of.open(k) = 2;
    put_shared(of.faced(pairs.first(pair)), Byte(2));
    put_shared(of.faced(pairs.second(pair)), Byte(2));
}
// Begins the contact of pair k by faces in one plane of which some part in this step, or changes its weight. Returns
// the energy that moves to the contact [J].
inline double begin_by_faces(const Moving &all, const ContactPairs &pairs, const FacePairs &of, Index k) {
    const Vector d = branch_of(all.pose.data, pairs, k);
    const double outer = outer_reach(pairs, of, k);
    if (bonded(pairs, k) || pairs.touch(k) == touching) return 0.0;
    double *const memory = &pairs.memory(k, 0);
    if (memory[stiff_before] > 0.0) {
        const ChosenFaces e(of.chosen(k));
        const double now = weight_of(of, e), before = 0.5 * ((of.open(e.first) == 1) + (of.open(e.second) == 1));
        return now > before ? (1.0 - before / now) * chosen_loads(all, pairs, of, k).energy : 0.0;
    }
    if (!(dot(d, d) < outer * outer)) return 0.0;
    const FacedCells found = faced_cells(of, TwoCells(all, pairs, k));
    if (found.number == 0.0 || found.number == of.chosen(k)) return 0.0;
    if (!in_one_plane(all, pairs, of, k, ChosenFaces(found.number))) return 0.0;
    of.chosen(k) = found.number;
    memory[began_at] = 0.0;
    pairs.touch(k) = facing;
    pairs.reach(k) = pairs.whole(k);
    return chosen_loads(all, pairs, of, k).energy;
}

// Adds the elastic energy of the pairs of a portion that touch by faces [J].
void sum_face_energies(const Range &range, const Moving &all, const ContactConstants &c, const ContactPairs &pairs,
                       const FacePairs &faces, const Ledger &ledger);

}  // namespace bondem
