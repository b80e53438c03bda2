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

// A facet that fails: its removal, with the energy of dilatation of its cells, and the part of the energy that pressure
// along its normal has stored.
struct FailingFacet {
    Removal removal;
    double along;  // [J]
    double k;  // [N/m]

    // The removal, given the energy of dilatation of the cells without the facet [J].
    Removal without(double dilatation) const {
        Removal found = removal;
        found.energy -= dilatation;
        found.pressed = least(found.pressed, root(2.0 * positive(along - dilatation) / k));
        return found;
    }
};
inline FailingFacet failing_facet(const Moving &all, const ElasticFacets &facets, Index k, OfCells<Dilated> cells) {
    const FacetColumns columns(facets);
    const Ends<double> ends = ends_of(all.pose.data, facets, k);
    const FacetShape<double> shape = columns.shape<double>(k);
    const OpenFacet<double> open = opened(ends, shape);
    const Vector normal = normal_of(facets, k);
    const BeamEnergy<double> parts = facet_energy(ends, shape, normal, columns.stiffness(k, 1.0));
    const double s = facets.integrity(k), dilatation = cells.i.energy + cells.j.energy, stiffness = facets.k(k);
    const double energy = s * (parts.normal + parts.shear + parts.bending + parts.twisting);
    const Vector n = present_normal(ends, normal);
    const double pull = s * dot(facet_pull(ends, shape, stiffness, {cells.i.stress, cells.j.stress}), n);
    return {{energy + dilatation, dot(open.gap, n), centre(all.pose.data, facets.i(k)) + open.arm_i, undefined,
             positive(-pull / stiffness)},
            s * parts.normal + dilatation, stiffness};
}

}  // namespace bondem
