// Motion of elements on a GPU. The thread of an element adds up the loads on the element, in the same order of bonds
// as the CPU, and moves the element.
#pragma once
#include "../passes/motion/body_forces.hpp"
#include "../passes/motion/moving.hpp"
#include "ranges.hpp"

namespace bondem {

// Adds the loads of the bonds of element p to a sum, in the order of the bonds, and returns it.
BONDEM_INLINE Row<double> gathered(Row<double> sum, Index p, const BondsOfElements &bonds, const LoadsOfBonds &from) {
    const Index m = from.load.shape[1];
    const auto load = [&](Index c, Index k) { return from.load.data[c * m + k]; };
    for (Index k = bonds.in_start(p); k < bonds.in_start(p + 1); k++)
        for (Index c = 0; c < 3; c++) {
            sum.column[c] += load(c, k);
            sum.column[4 + c] += load(6 + c, k);
        }
    for (Index e = bonds.out_start(p); e < bonds.out_start(p + 1); e++) {
        const Index k = bonds.out_bond(e);
        for (Index c = 0; c < 3; c++) {
            sum.column[c] -= load(c, k);
            sum.column[4 + c] += load(3 + c, k);
        }
    }
    return sum;
}
// Adds the loads of the bonds of an element to its sum in memory, to which other passes add further loads.
inline void gather_loads(Index e, const StepBlocks &blocks, const BondsOfElements &bonds, const LoadsOfBonds &from) {
    const Short row = blocks.ready_row(e);
    scatter(blocks.sums.data, row, gathered(gather(blocks.sums.data, row), blocks.ready(e), bonds, from));
}
inline void gather_dashpots(Index e, const StepBlocks &blocks, const BondsOfElements &bonds, const LoadsOfBonds &from,
                            const Dashpots &dashpots) {
    const Short row = blocks.ready_row(e);
    const Row<double> sum = gathered({}, blocks.ready(e), bonds, from);
    scatter(dashpots.sums.data, row, sum);
    for (Index c = 0; c < 8; c++) blocks.sums(row, c) += sum.column[c];
}

// The load of an element: the sum over its bonds, or the sum in memory, which is set to zero.
struct Gathered {
    const BondsOfElements &bonds;
    const LoadsOfBonds &from;
    BONDEM_INLINE Wrench<double> on(const One &one) const { return Wrench<double>(gathered({}, one.element, bonds, from)); }
};
struct Summed {
    const StepBlocks &blocks;
    BONDEM_INLINE Wrench<double> on(const One &one) const {
        const Wrench<double> load(gather(blocks.sums.data, one.row));
        clear(blocks.sums.data, one.row);
        return load;
    }
};

// The clock of element p; a postponed element does not open the next step.
BONDEM_INLINE Clock clock_on(const DeviceSpan &span, Index p) {
    Clock clock = clock_of(span);
    if (span.postponed.size() > 0 && span.postponed(p) != 0) clock.goes_on = 0;
    return clock;
}

// Moves element number e, which owns no row of the boundary, or number h of the elements that own one.
template <class Load, class Resisted>
BONDEM_INLINE void move_free_one(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                 const Load &load, const Resisted &resistance) {
    const One one(range_of(span, blocks, e), e);
    move(one, clock_on(span, one.element), all, load.on(one), NoRow{}, resistance, -1);
}
template <class Load, class Resisted>
BONDEM_INLINE void move_owner(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                              const Rows &rows, const Load &load, const Resisted &resistance) {
    const Index e = blocks.first_owner(0) + h;
    const One one(range_of(span, blocks, e), e);
    const Index r = rows.of(one.element);
    move(one, clock_on(span, one.element), all, load.on(one), BoundaryRow(rows, r), resistance, r);
}

inline void move_gathered(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                          const BondsOfElements &bonds, const LoadsOfBonds &from) {
    move_free_one(e, span, all, blocks, Gathered{bonds, from}, NoRow{});
}
inline void move_gathered_resisted(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                   const BondsOfElements &bonds, const LoadsOfBonds &from, const Resistance &resistance) {
    move_free_one(e, span, all, blocks, Gathered{bonds, from}, resistance);
}
inline void move_summed(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks) {
    move_free_one(e, span, all, blocks, Summed{blocks}, NoRow{});
}
inline void move_summed_resisted(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                 const Resistance &resistance) {
    move_free_one(e, span, all, blocks, Summed{blocks}, resistance);
}
inline void move_gathered_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                              const Rows &rows, const BondsOfElements &bonds, const LoadsOfBonds &from) {
    move_owner(h, span, all, blocks, rows, Gathered{bonds, from}, NoRow{});
}
inline void move_gathered_resisted_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                       const Rows &rows, const BondsOfElements &bonds, const LoadsOfBonds &from,
                                       const Resistance &resistance) {
    move_owner(h, span, all, blocks, rows, Gathered{bonds, from}, resistance);
}
inline void move_summed_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                            const Rows &rows) {
    move_owner(h, span, all, blocks, rows, Summed{blocks}, NoRow{});
}
inline void move_summed_resisted_row(Index h, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                                     const Rows &rows, const Resistance &resistance) {
    move_owner(h, span, all, blocks, rows, Summed{blocks}, resistance);
}

// ---- the opening of a step after a pause, and body forces

inline void open_element(Index p, const DeviceSpan &span, const Moving &all) { open_one(p, clock_of(span), all, NoRow{}); }
inline void open_element_or_row(Index p, const DeviceSpan &span, const Moving &all, const Rows &rows) {
    const Index r = rows.of(p);
    if (r < 0)
        open_one(p, clock_of(span), all, NoRow{});
    else
        open_one(p, clock_of(span), all, BoundaryRow(rows, r));
}
constexpr auto open_work_of_body = one_element<open_body_work>;
constexpr auto add_body_force = listed_element<add_body_forces>;
inline void add_work_of_body(Index e, const DeviceSpan &span, const Moving &all, const StepBlocks &blocks,
                             const BodyForces &body) {
    if (clock_on(span, blocks.ready(e)).goes_on) add_body_work(range_of(span, blocks, e), all, body);
}

}  // namespace bondem
