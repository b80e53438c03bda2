// The first of two passes over facets in a step: volume times dilatation of cells, from which their stresses follow.
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/damage_tables.hpp"
#include "../damage/pipeline.hpp"
#include "accumulation.hpp"

namespace bondem {
namespace {

// Marking of facets whose force reaches their bound, by the stresses of the step before.
struct FacetMarks {
    Marks marks;
    BONDEM_INLINE bool counts(const FacetColumns &, Index) { return true; }
    BONDEM_INLINE void mark(Index k, int known, const Row<Lanes> &a, const Row<Lanes> &b, const Ends<Lanes> &ends,
                            const FacetColumns &columns) {
        marks.mark(k, known, pull_squared(a, b, ends, columns, k), Lanes{});
    }
};

}  // namespace

// Adds contributions of the facets of a block to V θ of their cells.
void accumulate_dilatation(const Range &range, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells) {
    NoFacetMarks none;
    accumulate(range.first, range.last, all.pose.data, facets, cells, none);
}
BONDEM_PASS(accumulate_dilatation, bonds_of_blocks, "ends pose; adds swelling")

// Adds contributions of facets to V θ of their cells in bodies with many broken facets.
void accumulate_left_dilatation(const Range &range, const Moving &all, const ElasticFacets &facets,
                                const CellDilatation &cells) {
    LeftFacets left;
    accumulate(range.first, range.last, all.pose.data, facets, cells, left);
}
BONDEM_PASS(accumulate_left_dilatation, bonds_of_blocks, "ends pose; adds swelling")

// Adds contributions of facets to V θ of their cells, and marks facets near to failure.
void accumulate_and_mark(const Range &range, const Moving &all, const ElasticFacets &facets, const CellDilatation &cells,
                         const FailureBounds &bounds, const Candidates &candidates) {
    FacetMarks marked = {Marks(bounds, candidates, range)};
    accumulate(range.first, range.last, all.pose.data, facets, cells, marked);
    candidates.count(range.block) = marked.marks.count();
}
BONDEM_PASS(accumulate_and_mark, bonds_of_blocks, "ends pose pose.stress; adds swelling")

// Adds contributions of facets of other domains to V θ of shared cells, and sets their rows to zero.
void collect_dilatation(const Range &range, const StepBlocks &blocks, const CellDilatation &cells) {
    const Index n = cells.weight.size();
    for (Index e = range.first; e < range.last; e++)
        for (Index q = n + blocks.part(e); q < n + blocks.part(e + 1); q++) {
            cells.swelling(range.element[e]) += cells.swelling(q);
            cells.swelling(q) = 0.0;
        }
}
BONDEM_PASS(collect_dilatation, parts_of_shared, "changes swelling")

// Sets the stresses of cells by their complete V θ, which is set to zero.
void stress_cells(const Range &range, const Moving &all, const CellDilatation &cells) {
    for (Index e = range.first; e < range.last; e++) stress_cell(all.pose, cells, range.element[e]);
}
BONDEM_PASS(stress_cells, elements_of_blocks, "own given weight; changes swelling; writes pose.stress")

}  // namespace bondem
