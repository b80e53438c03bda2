// Passes that find the opening of active cracks, and the stresses of their cells (`opening_cracks.hpp`).
#include "crack_passes.hpp"

#include "../../registered.hpp"
#include "opening_cracks.hpp"

namespace bondem {
namespace {

#if defined(BONDEM_LANES)

// Prefetches the first two halves of a cell.
inline void ask_for_halves(const CrackLists &lists, Short p) {
    Index h = lists.head(p);
    for (int links = 0; links < 2; links++, h = lists.next(h)) {
        prefetch(lists.half.data + 16 * h);
        prefetch(lists.half.data + 16 * h + 8);
    }
}

#endif

}  // namespace

void begin_bases(const Range &range, const Moving &all, const CellDilatation &cells, const CrackLists &lists) {
    for (Index p = range.first; p < range.last; p++) {
        const double weight = cells.weight(p);
        lists.base(p) = weight != 0.0 ? all.pose(p, stress_column) / weight : 0.0;
    }
}
BONDEM_PASS(begin_bases, of_elements, "own pose.stress weight; writes base")

#if defined(BONDEM_LANES)

// Finds faces and halves of the active cracks, axes of cracks before any loss of integrity, and cracks that part.
void measure_cracks(const Range &range, const Moving &all, const ElasticFacets &facets, const CellSlack &slack,
                    const StressesOfCells &stresses, const CohesiveCracks &cracks, const CrackLists &lists) {
    const bool changes = range.clock.dt > 0.0;
    const Index count = lists.size(list_count::treated);
    over_places(range, count, [&](Index first, Index last, Index portion) {
        lists.flagged(portion) = 0;
        for (Index e = first; e < last; e++) lists.flag(e) = crack::unchanged;
        for_each_group_of(lists, first, last, count, [&](const CrackGroup &group) {
            measure_each(group, all, facets, slack, stresses, cracks, lists, portion, changes);
        });
    });
}
BONDEM_PASS(measure_cracks, of_cracks, "around leader pose tensor; adds half")

// Finds the stresses of all cells with active cracks.
void relax_cracked_cells(const Range &range, const Moving &all, const CellDilatation &cells,
                         const CrackLists &lists) {
    over_places(range, lists.size(list_count::cells), [&](Index first, Index last, Index) {
        for (Index q = first; q < last; q += lanes) {
            const Short *const cell = lists.cell.data + q;
            for (int n = 0; n < lanes; n++) ask_for_halves(lists, cell[2 * lanes + n]);
            relax(CellGroup{cell}, all, cells, lists);
        }
    });
}
BONDEM_PASS(relax_cracked_cells, of_cracks, "own base half weight; adds pose.stress")

// Finds the stresses of cells with active cracks again where they are out of date, and their leading cracks.
void relax_outdated_cells(const Range &range, const Moving &all, const CellDilatation &cells,
                          const CohesiveCracks &cracks, const CrackLists &lists) {
    over_places(range, lists.size(list_count::cells), [&](Index first, Index last, Index) {
        Short outdated[crack::of_portion + lanes];
        Index count = 0;
        for (Index q = first; q < last; q++) {
            const Short p = lists.cell(q);
            if (lists.outdated(p) == 0) continue;
            lists.outdated(p) = 0;
            ask_for_halves(lists, p);
            find_leader(cracks, lists, p);
            outdated[count++] = p;
        }
        if (count == 0) return;
        for (Index n = count; n < count + lanes; n++) outdated[n] = outdated[count - 1];
        for (Index n = 0; n < count; n += lanes) relax(CellGroup{outdated + n}, all, cells, lists);
    });
}
BONDEM_PASS(relax_outdated_cells, of_cracks, "own base half weight; adds leader pose.stress outdated")

#endif

}  // namespace bondem
