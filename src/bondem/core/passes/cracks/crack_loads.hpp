#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Finds forces and torques of the cracks that are treated one by one, and what they dissipate.
void load_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                 const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists);
// Adds up what they have dissipated, and writes down those of which nothing is left.
void log_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                const CrackLists &lists, const EventLog &log);
// Adds their forces to the sums of their cells.
void add_crack_loads(const Turn &turn, const Moving &all, const CrackLists &lists, const StepCut &cut);
// Energies of cracks and of the dilatation of cells with cracks.
void sum_stressed_dilatation(const Turn &turn, const Moving &all, const CellDilatation &cells,
                             const CrackEnergies &found);
void sum_heat(const Turn &turn, const StressesOfCells &stresses, const YieldingCells &cells,
              const CrackEnergies &found);
void sum_crack_energies(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                        const CohesiveCracks &cracks,
                        const CrackEnergies &found);
void add_crack_energies(const Turn &turn, const Moving &all, const WallConstraints &walls, const CrackEnergies &found,
                        const Portions &portions);
void write_heat(const Turn &turn, const CrackEnergies &found, const HistoryRows &history);
// Writes what facets have released beyond their fracture energy.
void write_crushing_of_facets(const Turn &turn, const FacetStrengths &strengths, const CohesiveCracks &cracks,
                              const EventLog &log, const HistoryRows &history);

}  // namespace bondem
