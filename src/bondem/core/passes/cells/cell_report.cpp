// Passes that sum the energies of facets and cells for the history, and check the rotations of facets.
#include "cell_passes.hpp"

#include "../../registered.hpp"
#include "energies.hpp"
#include "walls.hpp"

namespace bondem {
namespace {

// Direction from centre i to centre j of facet k in the reference [-].
Vector direction_at_rest(const Array<const double, 2> &rest, const ElasticFacets &facets, Index k) {
    const Vector d = rest.row<const Vector>(facets.j(k)) - rest.row<const Vector>(facets.i(k));
    const Vector between = over_nearest_image(d, facets.period.data);
    return between / length(between);
}

}  // namespace

void check_facets(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger) {
    Index wide = 0, lost = 0, not_finite = 0;
    const FacetColumns columns(facets);
    for (Index k = range.first; k < range.last; k++) {
        const Ends<double> ends = ends_of(all.pose.data, facets, k);
        const BeamTurn<double> turned = beam_turn(ends, direction_at_rest(all.rest, facets, k));
        const double c = least(turned.c1, turned.c2);
        double w2 = turned.w2;
        not_finite |= !(c * c + w2 < 4.0);
        if (facets.integrity(k) <= 0.0) continue;
        if (w2 < 0.75) w2 = swing_square(ends, w2, normal_of(facets, k), columns.stiffness(k, 1.0).H);
        wide += (c < 0.7) | (w2 < 0.75);
        lost += (c <= 0.0) | (w2 <= 0.25);
    }
    count_turns(ledger, wide, lost, not_finite);
}
BONDEM_PASS(check_facets, of_bonds, "ends pose")

void sum_facet_energies(const Range &range, const Moving &all, const ElasticFacets &facets, const Ledger &ledger) {
    ModeSums sum = {};
    sum_energies(range.first, range.last, all.pose.data, facets, sum);
    sum.add_to(ledger);
}
BONDEM_PASS(sum_facet_energies, of_bonds, "ends pose")

void sum_dilatation_energies(const Range &range, const CellDilatation &cells, const Ledger &ledger) {
    add_up(ledger, history_column::normal, range.first, range.last,
           [&](Index p) { return take_dilatation_energy(cells, p); });
}
BONDEM_PASS(sum_dilatation_energies, of_elements, "writes swelling")

// Sums the energies of half facets at walls.
void sum_energies_of_supports(const Range &, const Moving &all, const WallConstraints &walls, const Ledger &ledger) {
    add_up(ledger, history_column::normal, 0, walls.cell.size(),
           [&](Index g) { return energy_of_support(all.pose, all.rest, walls, g); });
}
BONDEM_PASS(sum_energies_of_supports, of_rows, "")

}  // namespace bondem
