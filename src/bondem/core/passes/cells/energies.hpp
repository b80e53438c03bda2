// Energies of facets and cells, for passes of a step and for given poses.
#pragma once
#include "../../ledger.hpp"
#include "facets.hpp"

namespace bondem {

inline void sum_energies(Index first, Index last, const double *pose, const ElasticFacets &facets, ModeSums &sum) {
    const FacetColumns columns(facets);
    for (Index k = first; k < last; k++) {
        sum.add(facets.integrity(k), facet_energy(ends_of(pose, facets, k), columns.shape<double>(k),
                                                  normal_of(facets, k), columns.stiffness(k, 1.0)));
    }
}

// Energy of dilatation ½ V λ θ² of a cell [J]; sets V θ to zero.
inline double take_dilatation_energy(const CellDilatation &cells, Index p) {
    const double grown = cells.swelling(p) + cells.given(p);
    cells.swelling(p) = 0.0;
    return 0.5 * cells.weight(p) * grown * grown;
}

}  // namespace bondem
