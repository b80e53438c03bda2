// Stresses of cells, and facets that begin to crack, on a GPU. Passes have one thread per facet or per cell. The
// thread of a cell adds up the moments of the forces on its facets.
#pragma once
#include "../passes/cells/cell_passes.hpp"
#include "../passes/cracks/onset_of_facets.hpp"
#include "../passes/cracks/stress_state.hpp"
#include "cells.hpp"
#include "cracks.hpp"

namespace bondem {

// ---- forces of facets and moments of cells

// Rows of `FacetArms`: levers of both cells in space, and T_b².
constexpr Index arm_of_i = 0, arm_of_j = 3, bending_row = 6;

inline void load_stored_facet(Index k, const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                              const LoadsOfBonds &to, const FacetArms &arms) {
    const FacetColumns columns(facets);
    const Row<double> i = gather(all.pose.data, facets.i(k)), j = gather(all.pose.data, facets.j(k));
    const Ends<double> ends = ends_of(i, j, facets.period.data);
    const double s = facets.integrity(k);
    const FacetShape<double> shape = columns.shape<double>(k);
    const FacetStiffness<double> stiffness = columns.stiffness<double>(k, s);
    const OpenFacet<double> open = opened(ends, shape);
    const Vector moment = bending_moment(ends, stiffness.H);
    const FacetLoads<double> loads = facet_loads(ends, shape, open, moment, stiffness.k, stresses_of(i, j, s));
    put(to, k, loads);
    for (Index d = 0; d < 3; d++) {
        stored.force(d, k) = -loads.force[d];
        arms.arm(arm_of_i + d, k) = open.arm_i[d];
        arms.arm(arm_of_j + d, k) = open.arm_j[d];
    }
    arms.arm(bending_row, k) = bending_square(ends, stored.bends(k), stiffness.H);
}
inline void gather_facet_moments(Index p, const FacetForces &stored, const BondsOfElements &bonds,
                                 const LoadsOfBonds &from, const FacetArms &arms) {
    double sum[7] = {};
    for_each_bond_of(bonds, p, [&](Index k, bool is_i) {
        const Vector f = (is_i ? -1.0 : 1.0) * Vector{from.load(0, k), from.load(1, k), from.load(2, k)};
        const Vector arm = vector_at<double>(arms.arm.data, arms.arm.shape[1], is_i ? arm_of_i : arm_of_j, k);
        const Symmetric3<double> m = symmetric_product(arm, f);
        for (Index c = 0; c < 6; c++) sum[c] += m[c];
        sum[6] += arms.arm(bending_row, k);
    });
    for (Index c = 0; c < 7; c++) stored.moment(p, c) = sum[c];
}
constexpr auto sum_moments_of_cell = one_element<sum_moments>;

// ---- stresses of cells

constexpr auto find_cell_stress = one_element<find_cell_stresses>;
constexpr auto find_still_stress = one_element<find_still_stresses>;
BONDEM_INLINE void add_surface(Index p, const Moving &all, const WallConstraints &walls, const RowOrder &of_cell,
                               const FacetTractions &tractions, const StressesOfCells &stresses) {
    for (Index l = 0; l < stresses.pressed.shape[0]; l++) add_traction_stress(tractions, stresses, l, p);
    for (Index e = of_cell.start(p); e < of_cell.start(p + 1); e++)
        add_wall_stress(all, walls, stresses, of_cell.load(e));
}
inline void add_surface_stress(Index p, const DeviceSpan &span, const Moving &all, const WallConstraints &walls,
                               const RowOrder &of_cell, const FacetTractions &tractions,
                               const StressesOfCells &stresses) {
    if (takes_time(span)) add_surface(p, all, walls, of_cell, tractions, stresses);
}
inline void add_still_surface_stress(Index p, const DeviceSpan &span, const Moving &all, const WallConstraints &walls,
                                     const RowOrder &of_cell, const FacetTractions &tractions,
                                     const StressesOfCells &stresses) {
    if (!takes_time(span)) add_surface(p, all, walls, of_cell, tractions, stresses);
}

// ---- facets that begin to crack

constexpr auto judge_cell = one_element<judge_cells>;
inline void mark_facet(Index k, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                       const FacetForces &stored, const FacetStrengths &strengths, const StressesOfCells &stresses,
                       const CrackOnset &onset) {
    if (!takes_time(span) || onset.listed(k) != 0) return;
    const Short i = facets.i(k), j = facets.j(k);
    const Byte judged = most(onset.judged(i), onset.judged(j));
    if (judged == 0) return;
    if (judged == 2) {
        onset.marked(k) = 2;
        return;
    }
    if (strengths.plane(k) != 0.0) return;
    const Row<double> of_i = gather(stresses.tensor.data, i), of_j = gather(stresses.tensor.data, j);
    const double size = of_i.column[7] + of_j.column[7], bends = least(of_i.column[6], of_j.column[6]);
    const auto place = [&] {
        const auto mean = mean_stress(gather_sums(stresses.tensor.data, i, j));
        return facet_in_body(all, facets, stored, mean, normal_of(facets, k), k);
    };
    if (begins_to_crack(traction_of(stored, strengths, k), size, bends, strengths.strength(k), place))
        onset.marked(k) = 1;
}
// Evaluates facet number e of the material planes.
inline void mark_plane(Index e, const DeviceSpan &span, const Moving &all, const ElasticFacets &facets,
                       const FacetForces &stored, const FacetStrengths &strengths, const CrackOnset &onset) {
    const Index k = strengths.planes(e);
    if (!takes_time(span) || onset.listed(k) != 0 || onset.marked(k) != 0) return;
    if (plane_begins(all, facets, stored, strengths, k)) onset.marked(k) = 1;
}
inline void begin_marked_crack(Index k, const DeviceSpan &span, const ElasticFacets &facets, const FacetForces &stored,
                               const FacetStrengths &strengths, const CrackOnset &onset, const CohesiveCracks &cracks) {
    if (takes_time(span) && onset.marked(k) != 0)
        begin_crack(facets, stored, strengths, onset, cracks, k, clock_of(span).step);
}

}  // namespace bondem
