#pragma once
#include "../../tables/cell_tables.hpp"
#include "../../tables/step_tables.hpp"

namespace bondem {

// Sets the stresses of all cells in any poses, and adds force and torque of facets and walls to the sums.
Index load_body(Index threads, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                const DilatationGradients &gradients, const WallConstraints &walls, const BeamSums &to);
// Adds force and torque of all facets at the stresses in the poses; rows of the sums are given.
Index load_facets(Index threads, const Poses &all, const ElasticFacets &facets, const BeamSums &to);
// Sums the energies of all facets, cells and walls [J]; that of dilatation is part of the normal energy.
Index measure_cell_energies(Index threads, const CellPoses &all, const ElasticFacets &facets, const CellDilatation &cells,
                            const DilatationGradients &gradients, const WallConstraints &walls,
                            const CellEnergies &found);
// Brings walls to a time.
Index place_walls(Index threads, const WallConstraints &walls, const WallTime &at);

}  // namespace bondem
