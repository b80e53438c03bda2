// Exact sums to which passes add energies and counts: for a row of the history of a run, or for a check of the run.
#pragma once
#include "exact_sum.hpp"
#include "tables/step_tables.hpp"

namespace bondem {

inline ExactSum &sum_of(const Ledger &ledger, Index column) { return exact_sum(ledger.sums, column); }
// Adds value(p) for p = first … last - 1 to a column of the balance.
template <class Value> inline void add_up(const Ledger &ledger, Index column, Index first, Index last, Value value) {
    ExactSum sum = {};
    for (Index p = first; p < last; p++)
        if (const double one = value(p); one != 0.0) sum.add(one);
    sum_of(ledger, column).add_shared(sum);
}

// Energies of bonds: normal, shear, bending, twisting.
struct ModeSums {
    ExactSum mode[4];

    // Adds the parts of the energy of a bond of integrity s.
    template <class Energy> inline void add(double s, const Energy &whole) {
        mode[0].add(s * whole.normal), mode[1].add(s * whole.shear);
        mode[2].add(s * whole.bending), mode[3].add(s * whole.twisting);
    }
    inline void add_to(const Ledger &ledger) const {
        for (Index c = 0; c < 4; c++) sum_of(ledger, history_column::normal + c).add_shared(mode[c]);
    }
    inline void put(double *energy) const {
        for (Index c = 0; c < 4; c++) energy[c] = mode[c].value();
    }
};

// Adds the counts of a portion to the balance: bonds beyond safe angles, beyond valid angles, and not finite.
inline void count_turns(const Ledger &ledger, Index wide, Index lost, Index not_finite) {
    add_to_shared(ledger.turned(turn_count::wide), wide);
    add_to_shared(ledger.turned(turn_count::lost), lost);
    add_to_shared(ledger.turned(turn_count::not_finite), not_finite);
}

}  // namespace bondem
