#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/stress_onset_tables.hpp"

namespace bondem {

// Finds the cells whose facets are evaluated: those whose stress may reach a criterion.
void judge_cells_by_mean_stress(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                                const StressOnset &onset, const CrackOnset &cracks);
void judge_cells_by_cone(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                         const StressOnset &onset, const CrackOnset &cracks);
void judge_cells_by_size(const Turn &turn, const StressesOfCells &stresses, const StressOnset &onset,
                         const CrackOnset &cracks);
// Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without cohesion.
void find_stress_candidates(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                            const StressesOfCells &stresses, const CrackOnset &cracks, const StressOnset &onset);
// Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives their strength.
void mark_failing_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                         const StressesOfCells &stresses, const CrackOnset &cracks, const StressOnset &onset);
// Keeps the strengths of facets that begin to crack.
void find_strengths_along(const Turn &turn, const StressOnset &onset);

}  // namespace bondem
