#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Computes the accelerations of the elements by their loads alone.
void find_accelerations(const Turn &turn, const Moving &all, const Rows &rows, const StepCut &cut,
                        const CorrectedMass &mass);
// Computes ρ β θ̈ of the cells by the accelerations of the elements.
void find_dilatation_inertia(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass);
// Computes the forces of the correction on the elements.
void find_inertia_forces(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass);
// Adds the forces of the correction to the sums of the elements.
void add_inertia_forces(const Turn &turn, const CorrectedMass &mass, const StepCut &cut);
// Subtracts from the kinetic energies what the mass of the cells has too much.
void subtract_dilatation_energies(const Turn &turn, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass,
                                  const Portions &portions);

}  // namespace bondem
