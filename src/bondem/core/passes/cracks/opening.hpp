#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Takes over V θ of cells without their cracks.
void begin_bases(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists);
// Finds faces and halves of the cracks that are treated one by one, and axes of those that have lost nothing yet.
void measure_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                    const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists);
// Finds the stresses of all cells with cracks that are treated one by one.
void relax_cracked_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists);
// Finds the stresses of cells with cracks that are out of date.
void relax_stale_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists);

}  // namespace bondem
