// Yielding of one cell, and the change of the levers from the centre of a cell to its facets and walls by its plastic
// deformation.
#pragma once
#include "../../laws/plasticity.hpp"
#include "../../laws/stress.hpp"
#include "single_cracks.hpp"
#include "stress_state.hpp"

namespace bondem {

// The plastic strain of the last increment, in space [-].
inline Symmetric3<double> strain_of(const YieldingCells &cells, Index p) {
    const double *e = &cells.plastic(p, plastic_column::increment);
    return {e[0], e[1], e[2], e[3], e[4], e[5]};
}
inline const PlasticDeformation<double> &deformation_of(const YieldingCells &cells, Index p) {
    return *reinterpret_cast<const PlasticDeformation<double> *>(&cells.plastic(p, plastic_column::deformation));
}
inline bool has_yielded(const YieldingCells &cells, Index p) { return cells.plastic(p, plastic_column::gamma) != 0.0; }
// True if the plastic deformation of cell p grows in this step.
inline bool grows(const YieldingCells &cells, Index p) {
    return has_yielded(cells, p) && work_of(strain_of(cells, p), strain_of(cells, p)) > 0.0;
}

// ---- flow

// Adds the second half of the dissipation of the last increment, by the stress after it, and clears the increment.
inline void close_increment(const StressesOfCells &stresses, const YieldingCells &cells, Index p) {
    using namespace plastic_column;
    if (!has_yielded(cells, p)) return;
    cells.plastic(p, heat) += 0.5 * stresses.volume(p) * work_of(tensor_of(stresses, p), strain_of(cells, p));
    for (Index d = 0; d < 6; d++) cells.plastic(p, increment + d) = 0.0;
}
// Remaining share of the cohesion of cell p, after the slip of the cells near it.
inline double cohesion_left(const YieldingCells &cells, Index p) {
    const Index first = cells.near_start(p), last = cells.near_start(p + 1);
    double sum = 0.0;
    for (Index e = first; e < last; e++) sum += cells.slipped(Index(cells.near(e)));
    return positive(1.0 - cells.fade(p) * sum / double(last - first));
}
// Closes the last increment of cell p, and calls on(strength) where the cell may slip.
template <class On>
inline void where_yields(const StressesOfCells &stresses, const YieldingCells &cells, const CrackOnset &onset, Index p, On on) {
    const double whole = cells.cohesion(p);
    if (whole == infinity) return;
    close_increment(stresses, cells, p);
    const YieldStrength<double> by = {cohesion_left(cells, p) * whole, cells.slope(p), cells.dilation(p),
                                      cells.stiffness(p), cells.carry(p)};
    if (by.cohesion == 0.0 && has_yielded(cells, p)) onset.judged(p) = 2;
    if (by.carry > 0.0 || yield_bound(invariants(tensor_of(stresses, p)), by, cells.cone != 0) > 0.0) on(by);
}

// Plastic flow of a cell: Δγ, its part for the next step, and Δε in space.
template <class T> struct PlasticFlow {
    T gamma, carry;
    Symmetric3<T> strain;
};
template <class T> BONDEM_INLINE PlasticFlow<T> flow_under(const Symmetric3<T> &s, const YieldStrength<T> &by, bool cone) {
    const PrincipalStress<T> found = principal(s);
    const PlasticStep<T> step = cone ? cone_step(found, invariants(s), by) : slip_step(found, by);
    return {step.gamma, step.carry, plastic_strain(found, step)};
}
// Applies a plastic flow to cell p, with half of its dissipation, by the stress before it; stores the carried slip.
inline void flow(const Moving &all, const StressesOfCells &stresses, const YieldingCells &cells, Index p,
                 const PlasticFlow<double> &by) {
    using namespace plastic_column;
    cells.carry(p) = by.carry;
    if (!(by.gamma > 0.0)) return;
    double *const row = &cells.plastic(p, 0);
    auto &P = *reinterpret_cast<PlasticDeformation<double> *>(row + deformation);
    const Symmetric3<double> &e = by.strain;
    P = deformed(P, turned_by(inverse(matrix_of(orientation(gather(all.pose.data, Short(p))))), e));
    for (Index d = 0; d < 6; d++) row[increment + d] += e[d];
    row[gamma] += by.gamma;
    row[heat] += 0.5 * stresses.volume(p) * work_of(tensor_of(stresses, p), strain_of(cells, p));
}

// ---- levers

// Updates lever k of a table from its value without plastic strain.
inline void stretch_lever(const Array<int32_t, 2> &lever, const Array<int32_t, 2> &base,
                          const Array<const double, 1> &pitch, const PlasticDeformation<double> &P, Index k) {
    const Vector b = {pitch(0) * double(base(0, k)), pitch(1) * double(base(1, k)), pitch(2) * double(base(2, k))};
    const Vector to = stretched(P, b);
    for (Index d = 0; d < 3; d++) lever(d, k) = int32_t(nearest(to[d] / pitch(d)));
}
// Updates the levers of cell p, whose slip other cells may read from now on.
inline void stretch_cell(const ElasticFacets &facets, const FacetsOfCells &of_cells, const YieldingCells &cells, Index p) {
    const PlasticDeformation<double> &P = deformation_of(cells, p);
    cells.slipped(p) = cells.plastic(p, plastic_column::gamma);
    for_each_bond_of(of_cells, p, [&](Index k, bool is_i) {
        stretch_lever(is_i ? facets.lever_i : facets.lever_j, is_i ? cells.base_i : cells.base_j, facets.pitch, P, k);
    });
}
// Updates the lever of wall g.
inline void stretch_yielding_wall(const WallConstraints &walls, const YieldingCells &cells, Index g) {
    walls.arm.row<Vector>(g) = stretched(deformation_of(cells, walls.cell(g)), cells.base_wall.row<const Vector>(g));
}
// Updates the lever of wall g after strains have changed the lever without plastic strain.
inline void stretch_from_present(const WallConstraints &walls, const YieldingCells &cells, Index g) {
    cells.base_wall.row<Vector>(g) = walls.arm.row<Vector>(g);
    stretch_yielding_wall(walls, cells, g);
}
// Updates the levers of the crack of facet k if one of its cells deforms plastically in this step.
inline void stretch_crack(const ElasticFacets &facets, const YieldingCells &cells, const CohesiveCracks &cracks, Index k) {
    if (grows(cells, facets.i(k)) || grows(cells, facets.j(k))) write_levers(facets, cracks, k);
}

// ---- work

// Work of load l on the free facets of cell p in its last increment of plastic strain, at full load [J].
inline double yielding_work(const StressesOfCells &stresses, const YieldingCells &cells, Index l, Index p) {
    return work_of(stresses.pressed.row<const Symmetric3<double>>(l, p), strain_of(cells, p));
}
// Adds the work of loads on free facets of cell p to the row that the cell owns.
inline void add_yielding_work_of(const FacetTractions &tractions, const StressesOfCells &stresses, const YieldingCells &cells,
                                 const Rows &rows, Index p) {
    for (Index l = 0; l < stresses.pressed.shape[0]; l++)
        rows.work(rows.of(p)) += tractions.factor(l) * yielding_work(stresses, cells, l, p);
}

}  // namespace bondem
