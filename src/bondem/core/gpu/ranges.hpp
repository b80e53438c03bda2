// Passes of the CPU that a GPU runs unchanged: one call in all, or one per element or range of elements or bonds.
#pragma once
#include "../steps.hpp"
#include "../tables/device_tables.hpp"
#include "for_each.hpp"

namespace bondem {

static_assert(sizeof(Clock) == 9 * sizeof(Index));
BONDEM_INLINE Clock &clock_of(const DeviceSpan &span) { return *reinterpret_cast<Clock *>(span.clock.data); }

// The part of a step that consists of element p alone.
BONDEM_INLINE Range range_of(const DeviceSpan &span, Index p) {
    return {clock_of(span), p, p + 1, p + 1, nullptr, nullptr, p, nullptr};
}
// The part of a step that consists of element number e of the list of its only block.
BONDEM_INLINE Range range_of(const DeviceSpan &span, const StepBlocks &blocks, Index e) {
    return {clock_of(span), e, e + 1, e + 1, blocks.ready.data, blocks.ready_row.data, 0, nullptr};
}
BONDEM_INLINE const StepBlocks &blocks_among(const StepBlocks &blocks) { return blocks; }
template <class... Tables> BONDEM_INLINE const StepBlocks &blocks_among(const StepBlocks &blocks, const Tables &...) {
    return blocks;
}
template <class Table, class... Tables>
BONDEM_INLINE const StepBlocks &blocks_among(const Table &, const Tables &...tables) {
    return blocks_among(tables...);
}
// The part of a step that consists of portion b of all elements or bonds, whose terms a thread adds up. Sums of a CPU
// have longer portions and the same bits, because they are exact.
BONDEM_INLINE Range portion_of(const DeviceSpan &span, Index b, Index count) {
    const Index last = least((b + 1) * terms_of_thread, count);
    return {clock_of(span), b * terms_of_thread, last, last, nullptr, nullptr, b, nullptr};
}

// A pass of the CPU as a pass over an index, which calls it with the range of that index.
template <auto pass> struct OneRange;
template <class... Tables, void (*pass)(const Range &, const Tables &...)> struct OneRange<pass> {
    static void once(Index, const DeviceSpan &span, const Tables &...tables) { pass(range_of(span, 0), tables...); }
    static void element(Index p, const DeviceSpan &span, const Tables &...tables) {
        pass(range_of(span, p), tables...);
    }
    static void listed(Index e, const DeviceSpan &span, const Tables &...tables) {
        pass(range_of(span, blocks_among(tables...), e), tables...);
    }
    static void elements(Index b, const DeviceSpan &span, const Tables &...tables) {
        pass(portion_of(span, b, span.n), tables...);
    }
    static void bonds(Index b, const DeviceSpan &span, const Tables &...tables) {
        pass(portion_of(span, b, span.m), tables...);
    }
};
// A pass of the CPU for all (index 0), one element, a place in a list of elements, a portion of elements or bonds.
template <auto pass> constexpr As<&OneRange<pass>::once> once;
template <auto pass> constexpr As<&OneRange<pass>::element> one_element;
template <auto pass> constexpr As<&OneRange<pass>::listed> listed_element;
template <auto pass> constexpr As<&OneRange<pass>::elements> portion_of_elements;
template <auto pass> constexpr As<&OneRange<pass>::bonds> portion_of_bonds;

// Advances the clock by `ahead` steps and sets its flags; for a step of no duration its coefficients are 0.
inline void set_clock(Index, const DeviceSpan &span, const StepScheme &scheme, const Tick &tick) {
    Clock &clock = clock_of(span);
    const double moving = tick.still ? 0.0 : 1.0;
    clock.step += tick.ahead;
    clock.time = scheme.origin + double(clock.step) * scheme.dt;
    clock.dt = moving * scheme.dt;
    clock.finish = moving * scheme.finish;
    clock.begin = moving * scheme.begin;
    clock.extra = moving * scheme.extra;
    clock.goes_on = tick.goes_on;
    clock.first = tick.first;
}
// Advances the row of the history to which the next record is written.
inline void count_record(Index, const DeviceSpan &span) { clock_of(span).record++; }

}  // namespace bondem
