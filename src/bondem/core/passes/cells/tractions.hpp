// Work of tractions on the free facets of one cell, by the dilatation of the cell.
#pragma once
#include "../../tables/step_tables.hpp"
#include "facets.hpp"

namespace bondem {

// True if a traction changes in this step.
inline bool comes(const FacetTractions &tractions) {
    for (Index l = 0; l < tractions.schedule.size(); l++)
        if (tractions.increment(l) != 0.0) return true;
    return false;
}
// Adds half the work of tractions that change to the row of cell p, by its present stress.
inline void add_traction_work_of(const Moving &all, const FacetTractions &tractions, const Rows &rows, Index p) {
    double &work = rows.work(rows.of(p));
    for (Index l = 0; l < tractions.schedule.size(); l++)
        work += 0.5 * tractions.increment(l) * all.pose(p, stress_column) * tractions.value(l, p);
}

}  // namespace bondem
