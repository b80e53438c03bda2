#pragma once
#include "../../steps.hpp"
#include "../../tables/cell_tables.hpp"

namespace bondem {

// Counts unbroken facets of a portion that are turned beyond the range of their energy, and beyond its end.
void check_facets(const Turn &turn, const Moving &all, const ElasticFacets &facets, const Portions &portions);
// Sums normal, shear, bending and twisting energy of the facets of a portion, without dilatation [J].
void sum_facet_energies(const Turn &turn, const Moving &all, const ElasticFacets &facets, const Portions &portions);
// Sums the energy of dilatation of a portion of cells, whose V θ is complete and is set to zero [J].
void sum_dilatation_energies(const Turn &turn, const CellDilatation &cells, const DilatationEnergy &found);

}  // namespace bondem
