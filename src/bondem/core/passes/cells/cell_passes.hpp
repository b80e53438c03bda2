// Passes over cells and their facets that are called by several source files or run on a device (GPU).
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"

namespace bondem {

// Counts unbroken facets of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25); c, w
// as in `laws/beam.hpp`. Reports poses that are not finite.
void check_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].
void sum_facet_energies(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger);
// Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].
void sum_dilatation_energies(const Range &range, const CellDilatation &cells, const Ledger &ledger);
// Sums the energies of gradients in a portion of cells, for the dilatation that facets have added up.
void sum_gradient_energies(const Range &range, const Moving &all, const CellDilatation &cells,
                           const WallConstraints &walls, const DilatationGradients &gradients, const Ledger &ledger);
// Subtracts the correction of the mass from the kinetic energies of a portion of cells.
void subtract_dilatation_energies(const Range &range, const Moving &all, const ElasticFacets &facets,
                                  const WallConstraints &walls, const CorrectedMass &mass, const Ledger &ledger);
// Sums ∂U/∂factor of the facets of a portion, in steps that need this sum.
void sum_strain_powers(const Range &range, const Moving &all, const CellStrains &strains,
                       const ElasticFacets &facets);
// Adds the work of strains that have changed, once the forces after the change are known.
void add_strain_work(const Range &range, const Moving &all, const CellStrains &strains, const WallConstraints &walls,
                     const Rows &rows);
// Finds V σ of cells from stored forces at the start of a run, with the bits of the sums of a step.
void sum_moments(const Range &range, const Moving &all, const ElasticFacets &facets, const FacetsOfCells &of_cells,
                 const FacetForces &stored);
// Subtracts the loads that a failure changes, times a sign, from the kept sum of postponed cell p: loads of a facet
// if either of its cells loses a facet, and loads of walls if cell p loses a facet.
void take_off_changing(double sign, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, const Postponed &postponed, Index p);
// Adds the loads after the failure to the kept sum of postponed cell p, and updates the loads of its walls.
void add_changed(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                 const FacetRelease &release, const Postponed &postponed, Index p);

}  // namespace bondem
