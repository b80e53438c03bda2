// Passes that write rows of the history, with time, energy balance and gauges. Also the check (guard) that the energy
// of a run is finite and bounded.
#include "record.hpp"

#include "../../ledger.hpp"
#include "../../registered.hpp"
#include "../../tables/columns.hpp"
#include "reading.hpp"

namespace bondem {
namespace {

using namespace history_column;

// Kinetic energy over all energy supplied so far above which a run counts as unstable. The ratio exceeds one by the
// error of the scheme only; unstable motion grows by orders of magnitude in a hundred steps.
constexpr double beyond = 1000.0;

struct Kinetic {
    double translation, rotation;  // [J]
};
Kinetic kinetic_energy(double *motion, Index p) {
    const Motion<double> moving(gather(motion, Short(p)));
    return {0.5 * dot(moving.v, moving.v) / moving.m, 0.5 * dot(moving.w, moving.w) / moving.u};
}

}  // namespace

void sum_element_energies(const Range &range, const Moving &all, const Ledger &ledger) {
    ExactSum moved = {}, turned = {}, damped = {}, rubbed = {};
    for (Index p = range.first; p < range.last; p++) {
        const Kinetic energy = kinetic_energy(all.motion.data, p);
        moved.add(energy.translation);
        turned.add(energy.rotation);
        damped.add(all.loss(p, 0));
        rubbed.add(all.loss(p, rubbed_loss));
    }
    sum_of(ledger, translation).add_shared(moved);
    sum_of(ledger, rotation).add_shared(turned);
    sum_of(ledger, loss).add_shared(damped);
    sum_of(ledger, friction).add_shared(rubbed);
}
BONDEM_PASS(sum_element_energies, of_elements, "")

void judge_energy(const Range &, const Rows &rows, const Ledger &ledger) {
    for (Index r = 0; r < rows.work.size(); r++) sum_of(ledger, work).add(absolute(rows.work(r)));
    double sum[history_column::count];
    for (Index c = 0; c < history_column::count; c++) sum[c] = sum_of(ledger, c).take();
    const double kinetic = sum[translation] + sum[rotation], supplied = sum[work];
    const bool not_finite = ledger.turned(turn_count::not_finite) != 0;
    ledger.found(guard_number::wide) = ledger.turned(turn_count::wide);
    ledger.found(guard_number::lost) = ledger.turned(turn_count::lost);
    for (Index c = 0; c < ledger.turned.size(); c++) ledger.turned(c) = 0;
    ledger.found(guard_number::ending) = 1;
    if (not_finite || !(kinetic < infinity && supplied < infinity)) return;
    ledger.budget(guard_energy::supplied) = most(ledger.budget(guard_energy::supplied), supplied);
    const double known = ledger.budget(guard_energy::start) + ledger.budget(guard_energy::supplied);
    ledger.found(guard_number::ending) = kinetic > beyond * known ? 2 : 0;
}
BONDEM_PASS(judge_energy, single, "")

void write_ledger(const Range &range, const Rows &rows, const Ledger &ledger, const HistoryRows &history) {
    double *const record = &history.record(range.clock.record, 0);
    for (Index r = 0; r < rows.work.size(); r++) sum_of(ledger, work).add(rows.work(r));
    for (Index c = 0; c < history_column::count; c++) record[c] += sum_of(ledger, c).take();
    record[time] = range.clock.time;
}
BONDEM_PASS(write_ledger, single, "")

// Writes three components of each gauge of elements.
void read_gauges(const Range &range, const Moving &all, const Rows &rows, const Gauges &gauges, const HistoryRows &history) {
    for (Index g = 0; g < gauges.quantity.size(); g++) {
        const Index quantity = gauges.quantity(g), reduction = gauges.reduction(g);
        const Index first = gauges.start(g), last = gauges.start(g + 1);
        if (quantity >= gauge_quantity::of_walls) continue;
        for (Index axis = 0; axis < 3; axis++) {
            gauge::Reading sum;
            for (Index e = first; e < last; e++) sum.add(gauge::read(all, rows, quantity, gauges.element(e), axis));
            history.record(range.clock.record, history_column::count + 3 * g + axis) = sum.reduced(reduction, last - first);
        }
    }
}
BONDEM_PASS(read_gauges, of_rows, "")

}  // namespace bondem
