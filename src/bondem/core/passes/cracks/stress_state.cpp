// Mean stresses σ of cells, from the last forces f on facets, cracks, walls and loaded free facets. With the volume
// V, the levers b from the centre of the cell and the symmetric part sym, V σ = sym Σ b⊗f. Also the choice of cells
// whose facets may crack.
//
// For facets, b and f are those of the same instant along fixed axes. For cracks, the levers b are in the frame of
// the cell, and R Σ b⊗f with the rotation R of the cell is the sum along fixed axes.
#include "stress_state.hpp"

#include "../../registered.hpp"
#include "carried.hpp"

namespace bondem {
namespace {

// Symmetric part of R b⊗f in space, from b_x f, b_y f and b_z f with the lever b in the reference.
Symmetric3<double> turned_moment(Quaternion<double> q, const double *c) {
    const Vector x = turned_by(q, Vector{c[0], c[4], c[8]}), y = turned_by(q, Vector{c[1], c[5], c[9]}),
                 z = turned_by(q, Vector{c[2], c[6], c[10]});  // R b f_x, R b f_y, R b f_z
    return {x.x, y.y, z.z, 0.5 * (y.x + x.y), 0.5 * (z.x + x.z), 0.5 * (z.y + y.z)};
}

void find_stresses(const Range &range, const Moving &all, const FacetForces &stored, const StressesOfCells &stresses) {
    for (Index p = range.first; p < range.last; p++) {
        const double *m = &stored.moment(p, 0), *c = &stresses.carried(p, 0);
        const double one = 1.0 / stresses.volume(p);
        const Symmetric3<double> more =
            c[has_cracks] != 0.0 ? turned_moment(orientation(gather(all.pose.data, Short(p))), c) : Symmetric3<double>{};
        double *const s = &stresses.tensor(p, 0);
        for (Index d = 0; d < 6; d++) s[d] = one * (m[d] + more[d]);
        s[tensor_column::bending] = m[6];
        put_size(stresses, p);
    }
}

void add_of_surface(const Moving &all, const WallConstraints &walls, const FacetTractions &tractions,
                    const StressesOfCells &stresses) {
    for (Index l = 0; l < stresses.pressed.shape[0]; l++)
        for (Index p = 0; p < stresses.volume.size(); p++) add_traction_stress(tractions, stresses, l, p);
    for (Index g = 0; g < walls.cell.size(); g++) add_wall_stress(all, walls, stresses, g);
}

}  // namespace

void find_cell_stresses(const Range &range, const Moving &all, const FacetForces &stored,
                        const StressesOfCells &stresses) {
    if (range.clock.dt > 0.0) find_stresses(range, all, stored, stresses);
}
BONDEM_PASS(find_cell_stresses, of_elements, "own carried moment pose; writes tensor")

void find_still_stresses(const Range &range, const Moving &all, const FacetForces &stored,
                         const StressesOfCells &stresses) {
    if (!(range.clock.dt > 0.0)) find_stresses(range, all, stored, stresses);
}
BONDEM_PASS(find_still_stresses, of_elements, "own carried moment pose; writes tensor")

// Adds forces of walls and of loads on free facets to the stresses of surface cells.
void add_surface_stresses(const Range &range, const Moving &all, const WallConstraints &walls,
                          const FacetTractions &tractions, const StressesOfCells &stresses) {
    if (range.clock.dt > 0.0) add_of_surface(all, walls, tractions, stresses);
}
BONDEM_PASS(add_surface_stresses, of_rows, "own arm load pose; changes tensor")

// Adds forces of walls and of loads on free facets to the stresses of surface cells, where no step is taken.
void add_still_surface_stresses(const Range &range, const Moving &all, const WallConstraints &walls,
                                const FacetTractions &tractions, const StressesOfCells &stresses) {
    if (!(range.clock.dt > 0.0)) add_of_surface(all, walls, tractions, stresses);
}
BONDEM_PASS(add_still_surface_stresses, of_rows, "own arm load pose; changes tensor")

void judge_cells(const Range &range, const FacetStrengths &strengths, const StressesOfCells &stresses,
                 const CrackOnset &onset) {
    if (!(range.clock.dt > 0.0)) return;
    for (Index p = range.first; p < range.last; p++) {
        const double *const s = &stresses.tensor(p, 0);
        const bool hot = s[tensor_column::size] + root(positive(s[tensor_column::bending])) > strengths.hot;
        onset.judged(p) = onset.cracked(p) != 0 || hot;
    }
}
BONDEM_PASS(judge_cells, of_elements, "own cracked tensor; writes judged")

}  // namespace bondem
