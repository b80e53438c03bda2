#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"

namespace bondem {

// Finds the mean stresses of cells from the forces of the last step on their facets and cracks.
void find_cell_stresses(const Turn &turn, const Moving &all, const FacetForces &kept,
                        const StressesOfCells &stresses);
// The same where forces of the present were found anew, without a step.
void find_still_stresses(const Turn &turn, const Moving &all, const FacetForces &kept,
                         const StressesOfCells &stresses);
void add_still_surface_stresses(const Turn &turn, const Moving &all, const WallConstraints &walls,
                                const FacetTractions &tractions, const StressesOfCells &stresses);
// Adds what walls and loads on free facets do to those of surface cells.
void add_surface_stresses(const Turn &turn, const Moving &all, const WallConstraints &walls,
                          const FacetTractions &tractions, const StressesOfCells &stresses);
// Lets cells yield, and finds those whose facets may crack.
void judge_cells(const Turn &turn, const FacetStrengths &strengths, const StressesOfCells &stresses,
                 const CrackOnset &onset);
void yield_cells(const Turn &turn, const Moving &all, const FacetStrengths &strengths,
                 const StressesOfCells &stresses,
                 const YieldingCells &cells, const CrackOnset &onset);
// Levers of facets, cracks and walls with the plastic deformation of their cells, where it has grown; and of all.
void stretch_cells(const Turn &turn, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                   const YieldingCells &cells);
void stretch_walls_and_cracks(const Turn &turn, const ElasticFacets &facets, const WallConstraints &walls,
                              const YieldingCells &cells, const CohesiveCracks &cracks);
void stretch_all_cells(const Turn &turn, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                       const YieldingCells &cells);
// The same where stress-free strains have set the levers without plastic strain anew.
void stretch_anew(const Turn &turn, const CellStrains &strains, const ElasticFacets &facets,
                  const FacetsOfCells &of_cells,
                  const WallConstraints &walls, const YieldingCells &cells);
// Adds the work of loads on free facets that move as their cells yield.
void add_yielding_work(const Turn &turn, const FacetTractions &tractions, const StressesOfCells &stresses,
                       const YieldingCells &cells, const Rows &rows);

}  // namespace bondem
