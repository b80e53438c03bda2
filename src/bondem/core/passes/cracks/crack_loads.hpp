#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Finds forces and torques of the cracks that are treated one by one, and what they dissipate.
void load_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const FacetStrengths &strengths,
                 const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists);
// Adds up what cracks have dissipated, and logs those without strength left.
void log_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CohesiveCracks &cracks,
                const CrackLists &lists, const EventLog &log);
// Adds the forces of cracks that are treated one by one to the sums of their cells.
void add_crack_loads(const Turn &turn, const Moving &all, const CrackLists &lists, const StepCut &cut);
// Sums the energy of dilatation of a portion of cells by their stresses [J].
void sum_stressed_dilatation(const Turn &turn, const Moving &all, const CellDilatation &cells,
                             const CrackEnergies &found);
// Sums the energy that the cells of a portion have dissipated by yielding [J].
void sum_heat(const Turn &turn, const StressesOfCells &stresses, const YieldingCells &cells,
              const CrackEnergies &found);
// Sums the energies of the cracks that are treated one by one [J].
void sum_crack_energies(const Turn &turn, const Moving &all, const ElasticFacets &facets,
                        const CohesiveCracks &cracks,
                        const CrackEnergies &found);
// Adds the energies of cracks and walls to those of the first portion of facets.
void add_crack_energies(const Turn &turn, const Moving &all, const WallConstraints &walls, const CrackEnergies &found,
                        const Portions &portions);
// Writes the heat of yielding into a record.
void write_heat(const Turn &turn, const CrackEnergies &found, const HistoryRows &history);
// Writes what facets have released beyond their fracture energy.
void write_crushing_of_facets(const Turn &turn, const FacetStrengths &strengths, const CohesiveCracks &cracks,
                              const EventLog &log, const HistoryRows &history);

}  // namespace bondem
