#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Adds what the facets of a block contribute to V θ of their cells.
void accumulate_dilatation(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells);
// Adds what facets contribute to V θ of their cells, where many facets have no integrity left.
void accumulate_left_dilatation(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                                const CellDilatation &cells);
// Adds what facets contribute to V θ of their cells, and marks facets near to failure.
void accumulate_and_mark(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                         const FailureBounds &bounds, const Candidates &candidates);
// Adds to V θ of shared cells what facets of other domains have for them, and leaves zeros there.
void collect_dilatation(const Turn &turn, const StepCut &cut, const CellDilatation &cells);
// Sets the stresses of cells, whose V θ is complete and left at zero.
void stress_cells(const Turn &turn, const Moving &all, const CellDilatation &cells);

}  // namespace bondem
