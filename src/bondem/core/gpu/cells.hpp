// Bodies of cells on a GPU. Passes have one thread per facet, cell, wall or traction on free facets, or per range of
// facets or cells. The facets of a cell that walls fix or support share one thread where they add to the same sums.
#pragma once
#include "../passes/cells/accumulation.hpp"
#include "../passes/cells/cell_passes.hpp"
#include "../passes/cells/dilatation_rates.hpp"
#include "../passes/cells/energies.hpp"
#include "../passes/cells/gradients.hpp"
#include "../passes/cells/tractions.hpp"
#include "../passes/cells/walls.hpp"
#include "../passes/cells/facet_verdicts.hpp"
#include "beams.hpp"

namespace bondem {

// ---- dilatation, in the first two rows of the loads of bonds, which the forces overwrite later

constexpr Index of_i = 0, of_j = 1;

inline void dilate_facet(Index k, const Moving &all, const ElasticFacets &facets, const LoadsOfBonds &to) {
    const FacetColumns columns(facets);
    const OfCells<double> grown = dilatation(ends_of(all.pose.data, facets, k), columns.shape<double>(k));
    const double s = facets.integrity(k);
    to.load(of_i, k) = s * grown.i;
    to.load(of_j, k) = s * grown.j;
}
inline void gather_dilatation(Index p, const CellDilatation &cells, const BondsOfElements &bonds, const LoadsOfBonds &from) {
    double sum = cells.swelling(p);
    for_each_bond_of(bonds, p, [&](Index k, bool is_i) { sum += from.load(is_i ? of_i : of_j, k); });
    cells.swelling(p) = sum;
}
inline void set_stress(Index p, const Moving &all, const CellDilatation &cells) { stress_cell(all.pose, cells, p); }

// ---- gradients of the dilatation

inline void sum_stress_difference(Index p, const Moving &all, const DilatationGradients &gradients) {
    gradients.difference(p) = difference_of(gradients, p, [&](Index q) { return all.pose(q, stress_column); });
}
inline void add_stress_difference(Index p, const Moving &all, const CellDilatation &cells,
                                  const DilatationGradients &gradients) {
    all.pose(p, stress_column) += cells.weight(p) * gradients.difference(p);
}
inline void bend_layer(Index p, const Moving &all, const WallConstraints &walls,
                       const DilatationGradients &gradients) {
    bend_cell(all.pose, walls, gradients, p);
}
inline void twist_layer(Index p, const Moving &all, const WallConstraints &walls,
                       const DilatationGradients &gradients) {
    twist_cell(all.pose, walls, gradients, p);
}
inline void add_layer_torque(Index e, const DilatationGradients &gradients, const StepBlocks &blocks) {
    for (Index axis = 0; axis < 3; axis++)
        blocks.sums(blocks.ready_row(e), 4 + axis) += gradients.torque(blocks.ready(e), axis);
}
constexpr auto sum_portion_of_gradients = portion_of_elements<sum_gradient_energies>;

// ---- the mass of waves of pressure

inline void find_acceleration_of(Index e, const Moving &all, const Rows &rows, const StepBlocks &blocks,
                                 const CorrectedMass &mass) {
    const Index p = blocks.ready(e);
    const double *const sum = &blocks.sums(blocks.ready_row(e), 0);
    if (rows.of(p) < 0) find_acceleration(all, mass, sum, p);
    else find_acceleration(all, rows, mass, sum, p);
}
constexpr auto find_dilatation_inertia_of = as<&find_inertia>;
constexpr auto find_inertia_force_of = as<&find_inertia_force>;
inline void add_inertia_force_of(Index e, const CorrectedMass &mass, const StepBlocks &blocks) {
    add_inertia_force(mass, &blocks.sums(blocks.ready_row(e), 0), blocks.ready(e));
}
constexpr auto subtract_portion_of_dilatation = portion_of_elements<subtract_dilatation_energies>;

// ---- forces

inline void load_facet(Index k, const Moving &all, const ElasticFacets &facets, const LoadsOfBonds &to) {
    put(to, k, loads_of(all.pose.data, facets, k));
}

// ---- walls that fix or support facets

inline void place_wall(Index g, const DeviceSpan &span, const WallConstraints &walls) {
    place_support(walls, clock_of(span).time, g);
    if (clock_of(span).first)
        for (Index axis = 0; axis < 3; axis++) walls.increment(g, axis) = 0.0;
}
// Sums the forces and torques of the walls of row r.
BONDEM_INLINE void sum_row(Index r, const WallConstraints &walls, const RowOrder &order, const Rows &rows) {
    double sum[6] = {};
    for (Index e = order.start(r); e < order.start(r + 1); e++)
        for (Index c = 0; c < 6; c++) sum[c] += walls.load(order.load(e), c);
    for (Index c = 0; c < 6; c++) rows.support(r, c) = sum[c];
}
BONDEM_INLINE void load_row(Index r, const Moving &all, const WallConstraints &walls, const RowOrder &order,
                            const Rows &rows) {
    for (Index e = order.start(r); e < order.start(r + 1); e++) load_support(all.pose, all.rest, walls, order.load(e));
    sum_row(r, walls, order, rows);
}
// Computes the forces and torques of the walls of row r before the first step of a call.
inline void begin_walls_of_row(Index r, const DeviceSpan &span, const Moving &all, const WallConstraints &walls,
                               const RowOrder &order, const Rows &rows) {
    if (clock_of(span).first) load_row(r, all, walls, order, rows);
}
inline void dilate_walls_of_row(Index r, const Moving &all, const WallConstraints &walls, const RowOrder &order,
                                const CellDilatation &cells) {
    for (Index e = order.start(r); e < order.start(r + 1); e++)
        cells.swelling(walls.cell(order.load(e))) += dilatation_of_support(all.pose, all.rest, walls, order.load(e));
}
inline void apply_walls_of_row(Index r, const Moving &all, const WallConstraints &walls, const RowOrder &order,
                               const Rows &rows) {
    for (Index e = order.start(r); e < order.start(r + 1); e++) add_half_work(walls, rows, order.load(e));
    for (Index e = order.start(r); e < order.start(r + 1); e++)
        all.loss(walls.cell(order.load(e)), rubbed_loss) += slide_support(all.pose, all.rest, walls, order.load(e));
    load_row(r, all, walls, order, rows);
    for (Index e = order.start(r); e < order.start(r + 1); e++) add_half_work(walls, rows, order.load(e));
}
// Adds the loads of walls to the sums of element number h of those that own rows of the boundary.
inline void add_wall_load(Index h, const Rows &rows, const StepBlocks &blocks) {
    const Index e = blocks.first_owner(0) + h;
    const double *load = &rows.support(rows.of(blocks.ready(e)), 0);
    for (Index axis = 0; axis < 3; axis++) {
        blocks.sums(blocks.ready_row(e), axis) += load[axis];
        blocks.sums(blocks.ready_row(e), 4 + axis) += load[3 + axis];
    }
}

// ---- tractions on free facets

inline void follow_traction(Index l, const DeviceSpan &span, const Timeline &timeline, const FacetTractions &tractions) {
    const double now = value_at(timeline, tractions.schedule(l), clock_of(span).time);
    tractions.increment(l) = clock_of(span).first ? 0.0 : now - tractions.factor(l);
    tractions.factor(l) = now;
}
inline void give_dilatation(Index p, const DeviceSpan &span, const FacetTractions &tractions, const CellDilatation &cells) {
    const Index count = tractions.schedule.size();
    bool changed = clock_of(span).first;
    for (Index l = 0; l < count; l++) changed |= tractions.increment(l) != 0.0;
    if (!changed) return;
    double sum = 0.0;
    for (Index l = 0; l < count; l++) sum += tractions.factor(l) * tractions.value(l, p);
    cells.given(p) = sum;
}
// Adds the work of tractions of cell number h of those that own rows of the boundary.
inline void add_traction_work_of_row(Index h, const Moving &all, const StepBlocks &blocks,
                                     const FacetTractions &tractions, const Rows &rows) {
    add_traction_work_of(all, tractions, rows, blocks.ready(blocks.first_owner(0) + h));
}

// ---- sums for the guard and the history

constexpr auto check_portion_of_facets = portion_of_bonds<check_facets>;
constexpr auto sum_portion_of_facets = portion_of_bonds<sum_facet_energies>;
constexpr auto sum_portion_of_cells = portion_of_elements<sum_dilatation_energies>;
inline void add_energy_of_support(Index g, const Moving &all, const WallConstraints &walls, const Ledger &ledger) {
    sum_of(ledger, history_column::normal).add_shared(energy_of_support(all.pose, all.rest, walls, g));
}

}  // namespace bondem
