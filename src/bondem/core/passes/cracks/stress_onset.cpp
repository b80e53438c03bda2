// Passes that find facets that begin to crack by a function of the stress, on the CPU. A pass over portions (ranges
// of consecutive facets) writes candidates, and further passes evaluate them together (`stress_onset_of_facets.hpp`).
#include "../../laws/criteria/cone.hpp"
#include "../../laws/criteria/mean_stress.hpp"
#include "../../registered.hpp"
#include "../../tables/cell_tables.hpp"
#include "../../tables/crack_tables.hpp"
#include "../../tables/stress_onset_tables.hpp"
#include "stress_onset_of_facets.hpp"

namespace bondem {
namespace {

// Finds the cells whose facets are evaluated: those whose stress may reach the criterion.
template <class Criterion>
void judge_cells_by(const Range &range, const StressesOfCells &stresses, const StressFunction &by, const CandidateFacets &onset,
                    const CrackOnset &cracks) {
    if (range.clock.dt > 0.0)
        for (Index p = range.first; p < range.last; p++) judge_cell_by<Criterion>(stresses, by, onset, cracks, p);
}

}  // namespace

BONDEM_PASS_AS(judge_cells_by_mean_stress, of_elements, "own cracked tensor; writes judged", judge_cells_by<MeanStress>)
BONDEM_PASS_AS(judge_cells_by_cone, of_elements, "own cracked tensor; writes judged", judge_cells_by<Cone>)

// Finds the cells whose facets are evaluated: those whose stress is large enough for the criterion of a user.
void judge_cells_by_size(const Range &range, const StressesOfCells &stresses, const CandidateFacets &onset,
                         const CrackOnset &cracks) {
    if (range.clock.dt > 0.0)
        for (Index p = range.first; p < range.last; p++) judge_cell_of_user(stresses, onset, cracks, p);
}
BONDEM_PASS(judge_cells_by_size, of_elements, "own cracked tensor; writes judged")

// Writes the stresses of facets in tension, as candidates of a portion; marks facets of cells without cohesion.
void find_stress_candidates(const Range &range, const Moving &all, const ElasticFacets &facets,
                            const FacetForces &stored, const StressesOfCells &stresses, const CrackOnset &cracks,
                            const CandidateFacets &onset) {
    Index next = range.first, marked = 0;
    if (range.clock.dt > 0.0)
        for (Index k = range.first; k < range.last; k++) {
            const Byte judged = most(cracks.judged(facets.i(k)), cracks.judged(facets.j(k)));
            if (judged == 0 || cracks.listed(k) != 0) continue;
            if (judged == 2) {
                cracks.marked(k) = 2;
                marked++;
                continue;
            }
            with_candidate(all, facets, stored, stresses, onset, k,
                           [&](const Stress<double> &s) { next = write_candidate(onset, next, k, s); });
        }
    onset.number(range.block) = next - range.first;
    cracks.found(range.block) = marked;
}
BONDEM_PASS(find_stress_candidates, of_bonds, "ends judged pose tensor")

// Marks candidates that fail, and replaces their stresses by those whose index gives their strength.
void mark_failing_facets(const Range &, const Moving &all, const ElasticFacets &facets, const FacetForces &stored,
                         const StressesOfCells &stresses, const CrackOnset &cracks, const CandidateFacets &onset) {
    Index next = 0;
    for (Index c = 0; c < onset.total(0); c++) {
        if (onset.found(c) < 1.0) continue;
        const Index k = onset.bond(c);
        cracks.marked(k) = 1;
        cracks.found(k / bonds_of_portion)++;
        next = write_candidate(onset, next, k, stress_along(all, facets, stored, stresses, onset, k));
    }
    for (Index q = 0; q < onset.number.size(); q++) onset.number(q) = 0;
    if (next > 0) onset.number(0) = next;  // one after the other, as from one portion
}
BONDEM_PASS(mark_failing_facets, of_events, "ends pose tensor")

// Stores the strengths of facets that begin to crack.
void find_strengths_along(const Range &, const CandidateFacets &onset) {
    for (Index c = 0; c < onset.total(0); c++) keep_strength_along(onset, c);
}
BONDEM_PASS(find_strengths_along, of_rows, "")

}  // namespace bondem
