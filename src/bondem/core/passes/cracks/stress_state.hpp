// Mean stresses σ of cells, their sizes √(σ:σ), and the contributions of walls and of loads on free facets.
#pragma once
#include "../../laws/principal.hpp"
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../motion/elements.hpp"

namespace bondem {

inline Symmetric3<double> tensor_of(const StressesOfCells &stresses, Index p) {
    return stresses.tensor.row<const Symmetric3<double>>(p);
}
// Writes the size √(σ:σ) of the stress of cell p [Pa].
inline void put_size(const StressesOfCells &stresses, Index p) {
    stresses.tensor(p, tensor_column::size) = root(square_of(tensor_of(stresses, p)));
}
// Adds load l on free facets to the stress of cell p; `add_wall_stress` adds wall g to that of its cell.
inline void add_traction_stress(const FacetTractions &tractions, const StressesOfCells &stresses, Index l, Index p) {
    for (Index d = 0; d < 6; d++)
        stresses.tensor(p, d) += tractions.factor(l) * stresses.pressed(l, p, d) / stresses.volume(p);
    put_size(stresses, p);
}
inline void add_wall_stress(const Moving &all, const WallConstraints &walls, const StressesOfCells &stresses, Index g) {
    const Index p = walls.cell(g);
    const Vector arm = turned_by(orientation(gather(all.pose.data, Short(p))), walls.arm.row<const Vector>(g));
    const Symmetric3<double> m = symmetric_product(arm, walls.load.row<Vector>(g));
    for (Index d = 0; d < 6; d++) stresses.tensor(p, d) += m[d] / stresses.volume(p);
    put_size(stresses, p);
}

// Finds the mean stresses of cells from the forces of the last step on their facets and cracks.
void find_cell_stresses(const Range &range, const Moving &all, const FacetForces &stored,
                        const StressesOfCells &stresses);
// Finds the mean stresses of cells from present forces, where no step is taken.
void find_still_stresses(const Range &range, const Moving &all, const FacetForces &stored,
                         const StressesOfCells &stresses);
// Finds the cells whose facets may crack: those with cracks, and those whose stress may reach their strength.
void judge_cells(const Range &range, const FacetStrengths &strengths, const StressesOfCells &stresses,
                 const CrackOnset &onset);

}  // namespace bondem
