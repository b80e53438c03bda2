// Counts and energies of facets and cells for the guard and the history, on the CPU and on a device.
#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Counts unbroken facets of a portion beyond safe angles (c1 or c2 < 0.7, w² < 0.75) and valid ones (0, 0.25); c, w as in
// `laws/beam.hpp`. Reports poses that are not finite.
void check_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger);
// Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].
void sum_facet_energies(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger);
// Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].
void sum_dilatation_energies(const Range &range, const CellDilatation &cells, const Ledger &ledger);
// Sums the energies of gradients in a portion of cells, for the dilatation that facets have added up.
void sum_gradient_energies(const Range &range, const Moving &all, const CellDilatation &cells, const WallConstraints &walls,
                           const DilatationGradients &gradients, const Ledger &ledger);
// Subtracts the correction of the mass from the kinetic energies of a portion of cells.
void subtract_dilatation_energies(const Range &range, const Moving &all, const ElasticFacets &facets,
                                  const WallConstraints &walls, const CorrectedMass &mass, const Ledger &ledger);

}  // namespace bondem
