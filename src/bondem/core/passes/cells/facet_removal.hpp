// Changes by the failure of a facet: its own energy, and the stresses and energies of its two cells.
//
// At given poses the energy of dilatation of a cell depends on its unbroken facets. The energy that a failing facet
// releases therefore follows from its two cells, and from the facets that have failed before in the step. `left(k)`
// is the integrity of facet k after these failures.
#pragma once
#include "../damage/integrity.hpp"
#include "facet_neighbours.hpp"
#include "facet_verdicts.hpp"
#include "walls.hpp"

namespace bondem {

// λ / V of a cell with its unbroken facets; failed facets open until they have no traction.
template <class Left> inline double weight_left(const FacetRelease &release, Index p, Left left) {
    double inward = 0.0, outward = 0.0;
    for_each_bond_of(release, p, [&](Index k, bool is_i) {
        (is_i ? outward : inward) += (1.0 - left(k)) * (is_i ? release.slack_i(k) : release.slack_j(k));
    });
    return release.whole(p) / (release.whole(p) * (inward + outward) + 1.0);
}

// Stress of a cell [Pa], and its energy of dilatation [J].
struct Dilated {
    double stress, energy;
};
template <class Left>
inline Dilated dilated(const Moving &all, const ElasticFacets &facets, const WallConstraints &walls,
                       const FacetRelease &release, Index p, double weight, Left left) {
    const FacetColumns columns(facets);
    double grown = release.given(p);
    for_each_wall_of(release, p, [&](Index g) { grown += dilatation_of_support(all.pose, all.rest, walls, g); });
    for_each_facet_of(release, p, [&](Index k) {
        const double s = left(k);
        if (s <= 0.0) return;
        const OfCells<double> both = dilatation(ends_of(all.pose.data, facets, k), columns.shape<double>(k));
        grown += s * (facets.i(k) == Short(p) ? both.i : both.j);
    });
    return {weight * grown, 0.5 * weight * grown * grown};
}

// The removal of facet k, without the released energy of dilatation.
inline Removal removal_of_facet(const Moving &all, const ElasticFacets &facets, Index k) {
    const FacetColumns columns(facets);
    const Ends<double> ends = ends_of(all.pose.data, facets, k);
    const FacetShape<double> shape = columns.shape<double>(k);
    const OpenFacet<double> open = opened(ends, shape);
    const Vector normal = normal_of(facets, k);
    const BeamEnergy<double> parts = facet_energy(ends, shape, normal, columns.stiffness(k, 1.0));
    const double energy = facets.integrity(k) * (parts.normal + parts.shear + parts.bending + parts.twisting);
    return {energy, dot(open.gap, present_normal(ends, normal)), centre(all.pose.data, facets.i(k)) + open.arm_i};
}

}  // namespace bondem
