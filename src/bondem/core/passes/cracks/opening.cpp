// Passes over the cracks that are treated one by one, and over their cells.
#include "opening.hpp"

#include "opening_cracks.hpp"

namespace bondem {
namespace {

#if defined(BONDEM_LANES)

void relax_all(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists,
               bool only_stale) {
    over_places(turn, lists.size(2), [&](Index first, Index last, Index) {
        for (Index q = first; q < last; q += lanes) {
            const Short *const cell = lists.cell.data + q;
            for (int n = 0; n < lanes; n++) {
                Index h = lists.head(cell[2 * lanes + n]);
                for (int links = 0; links < 2; links++, h = lists.node(h, 0)) {
                    prefetch(lists.half.data + 16 * h);
                    prefetch(lists.half.data + 16 * h + 8);
                }
            }
            relax(CellGroup{cell}, all, cells, lists, only_stale);
        }
    });
}

#endif

}  // namespace

void begin_bases(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    for (Index p = turn.first; p < turn.last; p++) {
        const double weight = cells.weight(p);
        lists.base(p) = weight != 0.0 ? all.pose(p, stress_column) / weight : 0.0;
    }
}

#if defined(BONDEM_LANES)

void measure_cracks(const Turn &turn, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                    const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    const bool changes = turn.clock.dt > 0.0;
    over_treated(turn, lists,
                 [&](Index first, Index last, Index portion) {
                     lists.flagged(portion) = 0;
                     for (Index e = first; e < last; e++) lists.flag(e) = crack::unchanged;
                 },
                 [&](const CrackGroup &group, Index portion) {
                     measure_each(group, all, facets, slack, stresses, cracks, lists, portion, changes);
                     put_levers(cracks, lists, group.e, group.e + group.known);
                 });
}

void relax_cracked_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    relax_all(turn, all, cells, lists, false);
}
void relax_stale_cells(const Turn &turn, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    relax_all(turn, all, cells, lists, true);
}

#endif

}  // namespace bondem
