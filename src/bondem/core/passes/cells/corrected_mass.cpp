// Passes that add the forces of the dispersion-corrected mass (`dilatation_rates.hpp`) before elements move.
#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "cell_passes.hpp"
#include "dilatation_rates.hpp"

namespace bondem {

// Computes the accelerations of the elements by their loads alone.
void find_accelerations(const Range &range, const Moving &all, const Rows &rows, const StepBlocks &blocks,
                        const CorrectedMass &mass) {
    for (Index e = range.first; e < range.last; e++) {
        const Index p = range.element[e];
        const double *const sum = &blocks.sums(range.row[e], 0);
        if (e < range.first_owner) find_acceleration(all, mass, sum, p);
        else find_acceleration(all, rows, mass, sum, p);
    }
}
BONDEM_PASS(find_accelerations, elements_of_blocks, "own Rows.force motion sums; writes CorrectedMass.acceleration")

// Computes ρ β θ̈ of the cells by the accelerations of the elements.
void find_dilatation_inertia(const Range &range, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass) {
    for (Index p = range.first; p < range.last; p++) find_inertia(p, all, facets, walls, mass);
}
BONDEM_PASS(find_dilatation_inertia, of_elements, "own arm; ends CorrectedMass.acceleration pose; adds inertia")

// Computes the forces of the correction on the elements.
void find_inertia_forces(const Range &range, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass) {
    for (Index p = range.first; p < range.last; p++) find_inertia_force(p, all, facets, walls, mass);
}
BONDEM_PASS(find_inertia_forces, of_elements, "own arm; ends inertia pose; adds force")

// Adds the forces of the correction to the sums of the elements.
void add_inertia_forces(const Range &range, const CorrectedMass &mass, const StepBlocks &blocks) {
    for (Index e = range.first; e < range.last; e++)
        add_inertia_force(mass, &blocks.sums(range.row[e], 0), range.element[e]);
}
BONDEM_PASS(add_inertia_forces, elements_of_blocks, "own force; changes sums")

void subtract_dilatation_energies(const Range &range, const Moving &all, const ElasticFacets &facets, const WallConstraints &walls, const CorrectedMass &mass,
                                  const Ledger &ledger) {
    add_up(ledger, history_column::translation, range.first, range.last,
           [&](Index p) { return -surplus_of_kinetic_energy(all, facets, walls, mass, p); });
}
BONDEM_PASS(subtract_dilatation_energies, of_elements, "")

}  // namespace bondem
