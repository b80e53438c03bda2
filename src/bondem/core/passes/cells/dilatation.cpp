// The first of two passes over facets: V θ of the cells, added up in the order of the facets, and with it their stresses.
#include "dilatation.hpp"

#include "accumulation.hpp"

namespace bondem {

void accumulate_dilatation(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells) {
    accumulate(turn.first, turn.last, all.pose.data, facets, cells);
}

void collect_dilatation(const Turn &turn, const StepCut &cut, const CellDilatation &cells) {
    const Index n = cells.weight.size();
    for (Index e = turn.first; e < turn.last; e++)
        for (Index q = n + cut.part(e); q < n + cut.part(e + 1); q++) {
            cells.swelling(turn.element[e]) += cells.swelling(q);
            cells.swelling(q) = 0.0;
        }
}

void stress_cells(const Turn &turn, const Moving &all, const CellDilatation &cells) {
    for (Index e = turn.first; e < turn.last; e++) stress_cell(all.pose, cells, turn.element[e]);
}

}  // namespace bondem
