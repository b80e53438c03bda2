// Tractions on free facets, and their effect on the dilatation θ of cells.
//
// A traction t on a free facet adds A m · (d t / 2G) to V θ of its cell, with the symbols of `laws/cell.hpp`. With
// this θ, Σ ½ V λ θ² over cells is the potential of dilatation and constant tractions. A traction that changes does
// the work σ d(V θ), with σ = λ θ the stress of the cell.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../boundary/timeline.hpp"
#include "tractions.hpp"

namespace bondem {

// Sets the factors of tractions at the time of the clock, and their contributions to V θ of cells.
void follow_tractions(const Range &range, const Timeline &timeline, const FacetTractions &tractions,
                      const CellDilatation &cells) {
    const Index count = tractions.schedule.size();
    bool changed = false;
    for (Index l = 0; l < count; l++) {
        const double now = value_at(timeline, tractions.schedule(l), range.clock.time);
        tractions.increment(l) = range.clock.first ? 0.0 : now - tractions.factor(l);
        changed |= now != tractions.factor(l);
        tractions.factor(l) = now;
    }
    if (!changed) return;
    for (Index p = 0; p < cells.given.size(); p++) {
        double sum = 0.0;
        for (Index l = 0; l < count; l++) sum += tractions.factor(l) * tractions.value(l, p);
        cells.given(p) = sum;
    }
}
BONDEM_PASS(follow_tractions, of_rows, "writes given")

// Adds half the work of tractions that change, by the present stresses, to the rows of their cells. A step calls it
// before and after the stresses change.
void add_traction_work(const Range &range, const Moving &all, const FacetTractions &tractions, const Rows &rows) {
    if (comes(tractions))
        for (Index e = range.first_owner; e < range.last; e++)
            add_traction_work_of(all, tractions, rows, range.element[e]);
}
BONDEM_PASS(add_traction_work, elements_of_blocks, "own pose.stress")

}  // namespace bondem
