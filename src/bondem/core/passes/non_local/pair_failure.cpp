// Bonds of the non-local law that fail by the mean stress of their two elements.
//
// The criterion is evaluated when the stresses of the step are known; bounds of principal stresses exclude most
// bonds. The energy released is that of the springs, without the work of extra forces (`laws/non_local.hpp`). The
// force of a failed bond is subtracted from the stresses of its elements, which the next step uses.
#include "../../registered.hpp"
#include "../../tables/damage_tables.hpp"
#include "non_local_passes.hpp"
#include "pair_removal.hpp"
#include "pair_verdict.hpp"

namespace bondem {

#if defined(BONDEM_LANES)

// Marks the bonds of a block that reach their criterion by bounds of the principal stresses of both elements.
void mark_pairs(const Range &range, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                const Candidates &candidates) {
    const Index first = candidates.begin(range.block), last = strengths.coefficient.size();
    Index next = first;
    for_each_group(range.first, range.last, [&](Group group) __attribute__((always_inline)) {
        const Index k = group.first;
        const double *const space = stresses.space.data;
        const Row<Lanes> i = gather(space, beams.i.data + k), j = gather(space, beams.j.data + k);
        Short place[lanes];
        for (int n = 0; n < lanes; n++) place[n] = Short(least(k + n, last - 1));
        const auto coefficient = [&](Index c) { return number_at(strengths.coefficient.data, 4, c, place); };
        const Coefficients<Lanes> own = {coefficient(0), coefficient(1), coefficient(2), coefficient(3)};
        const Lanes index = bound_of_index(i, j, own);
        const Lanes s = load(beams.integrity.data + k), zero = {}, one = zero + 1.0;
        if (__builtin_expect(any((s > zero ? index : zero) >= one), 0))
            for (int n = group.known; n < lanes; n++)
                if (s[n] > 0.0 && index[n] >= 1.0) candidates.marked(next++) = k + n;
    });
    candidates.count(range.block) = next - first;
}
BONDEM_PASS(mark_pairs, bonds_of_blocks, "ends space")

#endif

// Evaluates marked bonds of a block, and postpones the elements of failed bonds.
void judge_pairs(const Range &range, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                 const Candidates &candidates, const Postponed &postponed) {
    judge(
        range, candidates, [&](Index k) { return beams.integrity(k) > 0.0; },
        [&](Index k) { return verdict_of_pair(beams, stresses, strengths, k); },
        [&](Index k) { postpone_ends(postponed, beams, k); });
}
BONDEM_PASS(judge_pairs, bonds_of_blocks, "ends space; adds flag")

// Removes the bonds that fail: their force from the kept sums, and the energy of their springs.
void break_pairs(const Range &range, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                 const Candidates &candidates, const Postponed &postponed, const EventLog &log) {
    remove(range, candidates, log, [&](Index k) -> Removal {
        take_off_pair(&postponed.sum(beams.i(k), 0), true, bonds, k);
        take_off_pair(&postponed.sum(beams.j(k), 0), false, bonds, k);
        return removal_of_pair(all, beams, bonds, k);
    });
}
BONDEM_PASS(break_pairs, of_events, "still pose; adds sum")

// Subtracts failed bonds from the stresses of their elements, and sets their integrity to 0; after `break_pairs`.
void relieve_pairs(const Range &, const Moving &all, const Beams &beams, const NonLocalBonds &bonds,
                   const LaggedStresses &stresses, const BeamIntegrity &state, const Candidates &candidates) {
    for_each_failing(candidates, [&](Index k, Index) {
        relieve(all, stresses, beams.i(k), true, bonds, k);
        relieve(all, stresses, beams.j(k), false, bonds, k);
        end_pair(bonds, state, k);
    });
}
BONDEM_PASS(relieve_pairs, of_events, "own pose; adds stress")

// Finds the index of the criterion of every bond from the stresses in space.
Index index_pairs(Index, const Beams &beams, const LaggedStresses &stresses, const Strengths &strengths,
                  const FailureIndices &found) {
    for (Index k = 0; k < strengths.coefficient.size(); k++)
        found.index(k) = beams.integrity(k) > 0.0 ? verdict_of_pair(beams, stresses, strengths, k).index : 0.0;
    return 0;
}
BONDEM_CALL(index_pairs, "")

}  // namespace bondem
