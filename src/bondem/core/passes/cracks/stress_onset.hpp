#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/stress_onset_tables.hpp"

namespace bondem {

// Finds the cells whose facets are evaluated: those whose mean stress may reach the criterion.
void judge_cells_by_mean_stress(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                                const CandidateFacets &onset, const CrackOnset &cracks);
// Finds the cells whose facets are evaluated: those whose stress may reach the cone.
void judge_cells_by_cone(const Turn &turn, const StressesOfCells &stresses, const StressFunction &by,
                         const CandidateFacets &onset, const CrackOnset &cracks);
// Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.
void judge_cells_by_size(const Turn &turn, const StressesOfCells &stresses, const CandidateFacets &onset,
                         const CrackOnset &cracks);
// Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without cohesion.
void find_stress_candidates(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                            const StressesOfCells &stresses, const CrackOnset &cracks, const CandidateFacets &onset);
// Marks candidates that fail, and leaves these with the mean stress of their cells, of which the index gives their strength.
void mark_failing_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetForces &kept,
                         const StressesOfCells &stresses, const CrackOnset &cracks, const CandidateFacets &onset);
// Keeps the strengths of facets that begin to crack.
void find_strengths_along(const Turn &turn, const CandidateFacets &onset);

}  // namespace bondem
