// Calls of the common functions of CPU passes by a thread of a device, with a turn of one index.
#pragma once
#include "../steps.hpp"
#include "../tables/device_tables.hpp"

namespace bondem {

static_assert(sizeof(Clock) == 9 * sizeof(Index));
BONDEM_INLINE Clock &clock_of(const DeviceSpan &span) { return *reinterpret_cast<Clock *>(span.clock.data); }

// A turn of element p.
BONDEM_INLINE Turn turn_of(const DeviceSpan &span, Index p) {
    return {clock_of(span), p, p + 1, p + 1, nullptr, nullptr, p, nullptr};
}
// A turn of element number e of the list of a step, which on a device is one block.
BONDEM_INLINE Turn turn_of(const DeviceSpan &span, const StepCut &cut, Index e) {
    return {clock_of(span), e, e + 1, e + 1, cut.ready.data, cut.ready_row.data, 0, nullptr};
}
// A turn of portion b of elements or bonds.
BONDEM_INLINE Turn portion_of(const DeviceSpan &span, Index b, Index size, Index count) {
    const Index last = least((b + 1) * size, count);
    return {clock_of(span), b * size, last, last, nullptr, nullptr, b, nullptr};
}

// Sets the clock to a number of steps from the present one.
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
// The next record goes to the next row of the history.
inline void count_record(Index, const DeviceSpan &span) { clock_of(span).record++; }

}  // namespace bondem
