// Functions for one crack: its faces in space, onset, changes of status (`crack_states.cpp`), and weights of its cells.
#pragma once
#include "../damage/integrity.hpp"
#include "crack_places.hpp"

namespace bondem {

inline CrackIntegrity<double> left_of(const double *row) { return {{row[0], row[1], row[2]}, row[3]}; }
inline Quaternion<double> quaternion_of(const double *row) { return {row[0], row[1], row[2], row[3]}; }

// The crack of facet k in space, from the poses of its cells.
struct SingleCrack {
    Ends<double> ends;
    OfCells<double> stress;
    FacetCompliance<double> stiffness;
    double area;
    bool isotropic;
    CrackFaces<double> now;

    SingleCrack(const Array<double, 2> &pose, const ElasticFacets &facets, const CohesiveCracks &cracks, Index k)
        : ends(ends_of(pose.data, facets, k)),
          stress{pose(facets.i(k), stress_column), pose(facets.j(k), stress_column)} {
        const CrackFaceRow &face = face_of(cracks, k);
        const CrackStateRow &state = state_of(cracks, k);
        const CrackFrameRow &frame = frame_of(cracks, k);
        stiffness = {face.k, face.part};
        area = face.area;
        isotropic = state.kind == crack::isotropic;
        const CrackIntegrity<double> left = left_of(frame.left);
        now = crack_faces(ends, facet_shape(cracks, k), {face.normal[0], face.normal[1], face.normal[2]},
                          quaternion_of(frame.axes), left, state.kind > crack::of_material,
                          {state.slip[0], state.slip[1], state.slip[2]});
    }
    // True if a crack transmits only pressure along its normal, and friction.
    bool is_separate() const { return now.left.s[0] == 0.0 && now.left.grip == 0.0; }
};
// Stores the axes of crack k, given in space.
inline void put_axes(const CohesiveCracks &cracks, Index k, Quaternion<double> cell, const CrackAxes<double> &axes) {
    CrackAxes<double> own;
    for (int d = 0; d < 3; d++) own.e[d] = turned_by(inverse(cell), axes.e[d]);
    const Quaternion<double> q = stored_axes(own);
    double *const to = frame_of(cracks, k).axes;
    to[0] = q.w, to[1] = q.x, to[2] = q.y, to[3] = q.z;
}

// Largest slip over √A at which the faces of facet k still face each other [-].
inline double slide_of(const CohesiveCracks &cracks, Index k) { return softening_of(cracks, k).plane > 0.0f ? cracks.slide : 1.0; }

// Lever of a half in the reference [pitch].
BONDEM_INLINE const int32_t *lever_of(const CohesiveCracks &cracks, Index half) { return cracks.lever.data + 4 * (half - 1); }
// Clears a half, so that it adds nothing to V θ.
inline void clear_half(const CrackLists &lists, Index number) {
    SwellingHalf<double> &half = lists.half.row<SwellingHalf<double>>(number);
    half = {};
    half.turns[0] = half.turns[1] = half.turns[2] = infinity;
}

// Sets the status of the crack of facet k. In the table of facets it has no integrity while `active`, else its own.
inline void treat(const ElasticFacets &facets, const CohesiveCracks &cracks, Index k, int status) {
    history_of(cracks, k).status = status;
    cracks.listed(k) = Byte(1 + status);
    put_integrity(facets, k, status == crack::active ? 0.0 : cracks.integrity(k));
    put_shared(cracks.size(crack_number::out_of_date), Index(1));
}

// Weight λ / V of a cell in which the lost parts of cracks with counts(k), such as resting ones, act as free facets.
template <class Counts>
inline double weight_with(const CellSlack &of, const CohesiveCracks &cracks, Index p, Counts counts) {
    double slack = 0.0;
    for_each_bond_of(of, p, [&](Index k, bool is_i) {
        if (counts(k)) slack += (1.0 - cracks.integrity(k)) * (is_i ? of.slack_i(k) : of.slack_j(k));
    });
    return of.weight(p) / (1.0 + of.weight(p) * slack);
}
// True if crack k is active; `treated_as_facet` if it is resting or parted.
BONDEM_INLINE bool is_treated(const CohesiveCracks &cracks, Index k) { return cracks.listed(k) == 1 + crack::active; }
inline bool treated_as_facet(const CohesiveCracks &cracks, Index k) { return cracks.listed(k) > 1 + crack::active; }
inline void weigh_cracked(const CellDilatation &cells, const CellSlack &of, const CohesiveCracks &cracks, Index p) {
    cells.weight(p) = weight_with(of, cracks, p, [&](Index k) { return treated_as_facet(cracks, k); });
}

// Dissipation of facet k beyond its fracture energy; all of it for a facet of a cell without cohesion [J].
inline double crushed_by_facet(const FacetStrengths &strengths, const CohesiveCracks &cracks, Index k) {
    const double absorbed = softening_of(cracks, k).strength > 0.0 ? strengths.absorbed(k) : 0.0;
    return most(history_of(cracks, k).spent - absorbed, 0.0);
}

inline void write_levers(const ElasticFacets &facets, const CohesiveCracks &cracks, Index k) {
    CrackShapeRow &of = shape_of(cracks, k);
    for (Index d = 0; d < 3; d++) {
        of.lever_i[d] = cracks.lever(k, d) = facets.lever_i(d, k);
        of.lever_j[d] = cracks.lever(k, 4 + d) = facets.lever_j(d, k);
    }
}

// True if a crack with a given dissipation may slip: it absorbs one fracture energy by opening and one by slip.
template <class T> BONDEM_INLINE Mask<T> may_slip(T spent, T absorbed) { return spent < 2.0 * absorbed; }

// Stores the constants of a facet as it begins to crack.
inline void write_constants(const ElasticFacets &facets, const FacetForces &stored, const FacetStrengths &strengths,
                            const CohesiveCracks &cracks, Index k) {
    write_levers(facets, cracks, k);
    CrackShapeRow &shape = shape_of(cracks, k);
    CrackFaceRow &face = face_of(cracks, k);
    CrackSofteningRow &softening = softening_of(cracks, k);
    for (Index d = 0; d < 3; d++) {
        shape.share_i[d] = facets.share_i(d, k);
        shape.share_j[d] = facets.share_j(d, k);
        face.normal[d] = facets.normal(d, k);
    }
    shape.k = face.k = facets.k(k);
    face.part = strengths.part(k);
    face.area = strengths.area(k);
    face.friction = strengths.friction(k);
    for (Index d = 0; d < 6; d++) softening.H[d] = facets.H(d, k);
    softening.plane = float(strengths.plane(k));
    softening.bends = stored.bends(k);
    softening.brittleness = strengths.brittleness(k);
    softening.fastest = strengths.fastest(k);
    CrackHistoryRow &history = history_of(cracks, k);
    face.slips = may_slip(history.spent, strengths.absorbed(k)) ? 1.0 : 0.0;
    history.cohesion = strengths.cohesion(k);
    history.slip_brittleness = strengths.slip_brittleness(k);
    history.friction = strengths.friction(k);
}

// Starts the crack of facet k, which is marked.
inline void begin_crack(const ElasticFacets &facets, const FacetForces &stored, const FacetStrengths &strengths,
                        const CrackOnset &onset, const CohesiveCracks &cracks, Index k, Index step) {
    const bool loose = onset.marked(k) != 1;
    state_of(cracks, k) = {};
    state_of(cracks, k).fresh = 1.0;
    state_of(cracks, k).kind = loose || strengths.plane(k) != 0.0 ? crack::isotropic : crack::of_material;
    frame_of(cracks, k) = {};
    past_of(cracks, k) = {};
    for (int d = 0; d < 4; d++) frame_of(cracks, k).left[d] = past_of(cracks, k).left[d] = 1.0;
    put_axes(cracks, k, {1.0, 0.0, 0.0, 0.0}, axes_along(normal_of(facets, k)));
    history_of(cracks, k) = {};
    history_of(cracks, k).began = history_of(cracks, k).onset_step = double(step);
    softening_of(cracks, k).strength = loose ? 0.0 : strengths.strength(k);
    shape_of(cracks, k).top = 0.0;
    write_constants(facets, stored, strengths, cracks, k);
    for (Index d = 0; d < 3; d++) cracks.pull(k, d) = stored.force(d, k);
    treat(facets, cracks, k, crack::active);
    put_shared(onset.cracked(facets.i(k)), Byte(1));
    put_shared(onset.cracked(facets.j(k)), Byte(1));
    onset.marked(k) = 0;
}

}  // namespace bondem
